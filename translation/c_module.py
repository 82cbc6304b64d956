"""The module that Python calls: for each law a function that takes and gives Python's values."""

from __future__ import annotations

from collections.abc import Iterator

from translation.c_law import Function
from translation.c_names import c_name, key_of
from translation.kinds import FLAG, FLOAT, NOTHING, WHOLE, Array, Kind, Memory, Number, Parts

GIVE = {FLOAT: "PyFloat_FromDouble", WHOLE: "PyLong_FromLongLong", FLAG: "PyBool_FromLong"}


def module_text(functions: list[Function], prelude: str) -> str:
    """The file of the module, with an entry for each of these laws."""
    givers: dict[str, str] = {}
    wrappers = [_wrapper(one, givers) for one in functions]
    entries = [
        f'  {{"{key_of(one.law)}", (PyCFunction)(void (*)(void))py_{c_name(one.law)}, METH_FASTCALL, NULL}},'
        for one in functions
    ]
    return "\n".join(
        [
            "/* Written by `make laws` from the laws: change those and run it again. */",
            f"#define MOST_ARRAYS {max(map(_arrays, functions), default=1)}",
            prelude.rstrip(),
            '#include "laws.h"',
            "",
            *givers.values(),
            *wrappers,
            "static PyMethodDef methods[] = {",
            *entries,
            "  {NULL, NULL, 0, NULL},",
            "};",
            "extern const char digest_of_laws[];",
            "static PyModuleDef_Slot slots[] = {{0, NULL}};",
            "static PyModuleDef definition = {",
            '  PyModuleDef_HEAD_INIT, "_laws", digest_of_laws, 0, methods, slots, NULL, NULL, NULL,',
            "};",
            "PyMODINIT_FUNC PyInit__laws(void) { return PyModuleDef_Init(&definition); }",
            "",
        ]
    )


def _wrapper(function: Function, givers: dict[str, str]) -> str:
    name, key = c_name(function.law), key_of(function.law)
    declared, taken = [], [f"counted(law, count, {len(function.kinds)})"]
    for i, (word, kind) in enumerate(zip(function.arguments, function.kinds, strict=True)):
        declared.append(f"  {kind.c} a{i};")
        taken += _taken(f"a{i}", f"args[{i}]", word, kind, word in function.written)
        if isinstance(kind, Array) and kind.dimensions == 2 and word in function.columns:
            taken.append(f'has_columns(law, "{word}", a{i}.m, {function.columns[word]})')
    call = f"{name}({', '.join(f'a{i}' for i in range(len(function.kinds)))})"
    if function.returns != NOTHING:
        declared.append(f"  {function.returns.c} result;")
        call = f"result = {call}"
    tables = any(_is_table(kind) for kind in function.kinds)
    lines = [
        f"static PyObject *py_{name}(PyObject *self, PyObject *const *args, Py_ssize_t count) {{",
        f'  static const char law[] = "{key}";',
        "  Held held;",
        "  const Py_buffer *view;",
        *declared,
        "  (void)self, (void)view;",
        "  held.count = 0;",
        "  if (!(" + "\n        && ".join(taken) + "))",
        "    return let_go(&held);",
        f"  Py_BEGIN_ALLOW_THREADS {call}; Py_END_ALLOW_THREADS" if tables else f"  {call};",
        "  let_go(&held);",
        f"  return {_given('result', function.returns, givers)};",
        "}",
    ]
    return "\n".join(lines)


def _arrays(function: Function) -> int:
    """How many arrays a law takes."""

    def count(kind: Kind) -> int:
        return sum(map(count, kind.kinds)) if isinstance(kind, Parts) else isinstance(kind, Array | Memory)

    return max(1, sum(map(count, function.kinds)))


def _is_table(kind: Kind) -> bool:
    return (
        kind.dimensions == 2
        if isinstance(kind, Array)
        else isinstance(kind, Parts) and any(map(_is_table, kind.kinds))
    )


def _taken(place: str, source: str, word: str, kind: Kind, written: bool) -> Iterator[str]:
    """Conditions that hold once a value of Python stands in its place."""
    if isinstance(kind, Number):
        yield f"take_{kind.c}({source}, &{place})"
    elif isinstance(kind, Memory):
        flag = "true" if written else "false"
        yield f'take_memory(&held, {source}, law, "{word}", {flag}, {kind.of.length}, &view)'
        yield f"({place} = view->buf, true)"
    elif isinstance(kind, Array):
        flag = "true" if written else "false"
        what = f"'{kind.of.letter}', {kind.dimensions}, {flag}"
        yield f'take_array(&held, {source}, law, "{word}", {what}, &view)'
        sizes = "view->shape[0]" + (", view->shape[1]" if kind.dimensions == 2 else "")
        yield f"({place} = ({kind.c}){{view->buf, {sizes}}}, true)"
    else:
        assert isinstance(kind, Parts)
        yield f'take_tuple({source}, law, "{word}", {len(kind.kinds)})'
        for i, one in enumerate(kind.kinds):
            yield from _taken(
                f"{place}.{kind.field(i)}", f"PyTuple_GetItem({source}, {i})", word, one, written
            )


def _given(text: str, kind: Kind, givers: dict[str, str]) -> str:
    """A value for Python; the functions that make tuples go into ``givers``."""
    if kind == NOTHING:
        return "(Py_IncRef(Py_None), Py_None)"
    if isinstance(kind, Number):
        return f"{GIVE[kind]}({text})"
    assert isinstance(kind, Parts)
    if kind.c not in givers:
        parts = [_given(f"value.{kind.field(i)}", one, givers) for i, one in enumerate(kind.kinds)]
        lines = [f"  PyTuple_SetItem(tuple, {i}, {part});" for i, part in enumerate(parts)]
        givers[kind.c] = "\n".join(
            [
                f"static PyObject *give_{kind.c}({kind.c} value) {{",
                f"  PyObject *tuple = PyTuple_New({len(kind.kinds)});",
                "  if (tuple == NULL) return NULL;",
                *lines,
                "  return tuple;",
                "}",
            ]
        )
    return f"give_{kind.c}({text})"
