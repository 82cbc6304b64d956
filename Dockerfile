# docs/guide/container.md. A release names its base by digest: --build-arg BASE=python:3.11-slim-bookworm@sha256:...
ARG BASE=python:3.11-slim-bookworm

FROM ${BASE} AS build
# hadolint ignore=DL3008
RUN apt-get update && apt-get install --yes --no-install-recommends binutils
WORKDIR /source
COPY . .
# The versions that the project is tested with. pip stays in this stage.
RUN python3.11 -m venv /build \
    && /build/bin/pip wheel --no-cache-dir --no-deps --wheel-dir /wheels . ./server \
    && python3.11 -m venv --without-pip /opt/pointpred \
    && /build/bin/pip --python /opt/pointpred/bin/python install --no-cache-dir -c constraints.txt /wheels/*.whl \
    && cp container/healthy.py /opt/pointpred
# What libraries bring for their developers, and Arrow's ways to other machines: 120 MB that nothing here imports.
WORKDIR /opt/pointpred/lib/python3.11/site-packages
RUN find numpy pyarrow -type d -name tests -prune -exec rm -r {} + \
    && rm -r pyarrow/include pyarrow/src pyarrow/libarrow_flight.so* pyarrow/libarrow_python_flight.so* \
        pyarrow/_flight.*.so pyarrow/libarrow_s3.so* pyarrow/_s3fs.*.so \
    && strip --strip-unneeded pyarrow/*.so* uvloop/*.so yaml/*.so

FROM ${BASE}
COPY --from=build /opt/pointpred /opt/pointpred
ENV PYTHONDONTWRITEBYTECODE=1 \
    PYTHONUNBUFFERED=1 \
    POINTPRED_HOST=0.0.0.0 \
    POINTPRED_PORT=8765
WORKDIR /opt/pointpred
USER 65532:65532
EXPOSE 8765
STOPSIGNAL SIGTERM
HEALTHCHECK --interval=10s --timeout=3s --start-period=30s --retries=3 \
    CMD ["/opt/pointpred/bin/python", "-I", "/opt/pointpred/healthy.py"]
ENTRYPOINT ["/opt/pointpred/bin/pointpred"]
CMD ["serve"]
