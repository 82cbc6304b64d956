# The steps are functions of container/steps.sh, which also runs them where no Docker engine does.
FROM python:3.11-slim-bookworm AS build
WORKDIR /source
COPY . .
RUN ["sh", "container/steps.sh", "wheel"]
# hadolint ignore=DL3059
RUN ["sh", "container/steps.sh", "install"]

FROM python:3.11-slim-bookworm
COPY --from=build /opt/pointpred /opt/pointpred
ENV PYTHONDONTWRITEBYTECODE=1 \
    PYTHONUNBUFFERED=1 \
    POINTPRED_HOST=0.0.0.0 \
    POINTPRED_PORT=8765
WORKDIR /opt/pointpred
USER 65532:65532
EXPOSE 8765
STOPSIGNAL SIGTERM
HEALTHCHECK --interval=10s --timeout=3s --start-period=30s --start-interval=1s --retries=3 \
    CMD ["/opt/pointpred/bin/python", "-I", "/opt/pointpred/healthy.py"]
ENTRYPOINT ["/opt/pointpred/bin/pointpred"]
CMD ["serve"]
