"""Compile a function and all that it calls as one program: in a third of the time that numba takes for them one by one.

numba makes each function a program of its own, with machine code, a door for Python and a door for C, and optimises it once more
within each function that calls it. Here a function that is called by compiled code is a *part*: it is typed and translated once,
and kept as it is. Only a function that Python calls, an *entry*, is optimised with its parts, becomes machine code and is kept on
disk.
Also left out are passes over what no function here contains: closures, generators, `with`, literal loops, Python objects.

Nothing of this changes a result: the arithmetic is the same, in the same order.
"""

from __future__ import annotations

import contextlib
import gc
import hashlib
import time
from collections.abc import Callable, Iterator
from typing import Any

from numba.core import typed_passes, untyped_passes
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import CompilerBase
from numba.core.dispatcher import _FunctionCompiler  # type: ignore[attr-defined]
from numba.core.registry import CPUDispatcher
from numba.core.sigutils import normalize_signature
from numba.core.types.functions import BaseFunction
from numba.core.typing.templates import make_concrete_template

_OPTIONS = {
    "nopython": True,
    "error_model": "numpy",  # a division by zero gives inf or NaN: no branch, no exception
    "boundscheck": None,  # as NUMBA_BOUNDSCHECK says
    "no_cfunc_wrapper": True,
    "_nrt": False,  # compiled code allocates nothing, so nothing is counted or freed
}


class Estimate:
    """How long it takes to compile a program: the time of its first parts, scaled by the length of all.

    `tell` is called with that time [s], once in each program that is worth it. It is None at first: nobody is told.
    """

    WORTH_IT = 20  # functions
    FIRST = 0.25  # of the length of all parts: from here on the estimate is within a third of what it takes
    TRANSLATION = 0.7  # of the time; the rest is optimisation and machine code, which come at its end

    def __init__(self) -> None:
        self.tell: Callable[[float], None] | None = None
        self._start = self._length = self._done = 0.0

    def begin(self, entry: Callable[..., Any]) -> None:
        """A program begins, with the parts of this function."""
        parts = _parts_of(entry)
        self._start, self._done = time.perf_counter(), 0.0
        self._length = sum(map(_length, parts)) if len(parts) >= self.WORTH_IT else 0.0

    def add(self, part: Callable[..., Any]) -> None:
        """Count a part that has been translated; at the share `FIRST` of the whole, tell how long it will take."""
        before, self._done = self._done, self._done + _length(part)
        if self.tell and before < self.FIRST * self._length <= self._done:
            spent = time.perf_counter() - self._start
            self.tell(spent * self._length / self._done / self.TRANSLATION)


estimate = Estimate()


def _length(function: Callable[..., Any]) -> int:
    return len(function.__code__.co_code)


def _parts_of(function: Callable[..., Any]) -> set[Callable[..., Any]]:
    """The functions that a function calls, and those that they call, found by their names."""
    found: set[Callable[..., Any]] = set()
    waiting = [function]
    while waiting:
        caller = waiting.pop()
        called = {caller.__globals__.get(name) for name in caller.__code__.co_names}
        new = {other.py_func for other in called if isinstance(other, Function)} - found
        found |= new
        waiting += new
    return found


class _Program(JITCodeLibrary):
    """The code of an entry, with that of its parts, optimised once."""

    def add_linking_library(self, library: Any) -> None:
        library._ensure_finalized()
        self._linking_libraries += [library, *library._linking_libraries]

    def _optimize_functions(self, module: Any) -> None:
        module.data_layout = self._codegen._data_layout  # the passes over the whole program do the rest


class _PartCode(_Program):
    """The code of a part: as it was translated, and never finished alone."""

    def _ensure_finalized(self) -> None:
        pass


def _name_by_layout(state: Any) -> None:
    """Put the layout of the arguments into the name by which the linker knows a function.

    numba names a record by a number that is counted in each process, and a function by another. So code for aircraft with four
    and with five actuators, kept on disk by two processes, may bear one name, and a third process would run the one for both.
    """
    layout = hashlib.sha256("".join(map(str, state.args)).encode()).hexdigest()[:16]
    state.func_id.unique_id = f"{state.func_id.unique_id}_{layout}"


class _EntryLowering(typed_passes.NativeLowering):
    """The last but one pass: code from typed statements."""

    def run_pass(self, state: Any) -> bool:
        _name_by_layout(state)
        state.library = _Program(state.targetctx.codegen(), state.func_id.func_qualname)
        state.library.enable_object_caching()
        return bool(super().run_pass(state))


class _PartLowering(typed_passes.NativeLowering):
    """The same for a part. Its callers know it by a mark where they would have its address."""

    def run_pass(self, state: Any) -> bool:
        _name_by_layout(state)
        state.library = _PartCode(state.targetctx.codegen(), state.func_id.func_qualname)
        super().run_pass(state)
        mark, lowered = object(), state["cr"]
        state.targetctx.insert_user_function(mark, lowered.fndesc, [state.library])
        state["cr"] = lowered._replace(cfunc=mark)
        return True


class _Passes:
    """What numba calls a pass manager, without its accounts of each pass."""

    pipeline_name = "program"

    def __init__(self, lowering: type) -> None:
        self.exec_times: dict[str, Any] = {}
        self._passes = [
            untyped_passes.TranslateByteCode,
            untyped_passes.FixupArgs,
            untyped_passes.IRProcessing,
            untyped_passes.GenericRewrites,
            untyped_passes.ReconstructSSA,
            typed_passes.NopythonTypeInference,
            typed_passes.PreLowerStripPhis,
            typed_passes.IRLegalization,
            lowering,
            typed_passes.NoPythonBackend,
        ]

    def run(self, state: Any) -> None:
        for step in self._passes:
            step().run_pass(state)


class _Compiler(CompilerBase):
    lowering: type

    def __init__(self, *given: Any) -> None:
        super().__init__(*given)
        # numba reads all its registries again wherever a meaning is missing, as of `__array__` for each array of a record.
        self.state.targetctx.refresh = lambda: None

    def define_pipelines(self) -> list[_Passes]:
        return [_Passes(self.lowering)]


class _EntryCompiler(_Compiler):
    lowering = _EntryLowering

    def compile_extra(self, func: Callable[..., Any]) -> Any:
        estimate.begin(func)
        with _no_collection(), _remembered_types():
            return super().compile_extra(func)


class _PartCompiler(_Compiler):
    lowering = _PartLowering

    def define_pipelines(self) -> list[_Passes]:
        self.state.flags.no_cpython_wrapper = self.state.flags.no_compile = True
        return super().define_pipelines()


class Function(CPUDispatcher):
    """A compiled function: an entry where Python calls it, a part where compiled code does."""

    def __init__(
        self,
        py_func: Callable[..., Any],
        locals: dict[str, Any] | None = None,
        targetoptions: dict[str, Any] | None = None,
        pipeline_class: type[CompilerBase] = _EntryCompiler,
    ) -> None:
        options = _OPTIONS if targetoptions is None else targetoptions
        super().__init__(py_func, locals, options, pipeline_class)
        self._parts: dict[tuple[Any, ...], Any] = {}
        self._part_compiler = _FunctionCompiler(py_func, self.targetdescr, options, {}, _PartCompiler)

    def get_call_template(self, args: Any, kws: Any) -> Any:
        """numba's question, while it types a call: what comes out for arguments of these types? The part is compiled first."""
        signature, args = self._part_compiler.fold_argument_types(args, kws)
        types, name = tuple(args), self.py_func.__name__
        if types not in self._parts:
            self._parts[types] = self._part_compiler.compile(types, None)
            estimate.add(self.py_func)
        template = make_concrete_template(name, key=name, signatures=[self._parts[types].signature])
        return template, signature, args, {}

    def get_overload(self, sig: Any) -> Any:
        """numba's question, while it translates a call: which function is it?"""
        return self._parts[tuple(normalize_signature(sig)[0])].entry_point


@contextlib.contextmanager
def _no_collection() -> Iterator[None]:
    """Without garbage collection, which takes an eighth of the time of compiling, and finds little."""
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()
            gc.freeze()


@contextlib.contextmanager
def _remembered_types() -> Iterator[None]:
    """numba tries all meanings of an operator at each place where it stands, some twenty of a `+`. Here it tries them once."""
    plain, known = BaseFunction.get_call_type, {}

    def get_call_type(self: Any, context: Any, args: Any, kws: Any) -> Any:
        if kws:
            return plain(self, context, args, kws)
        key = (id(self), *map(id, args))
        if key not in known:  # the types are kept with it, so that no other gets their ids
            known[key] = (plain(self, context, args, kws), self, args)
        return known[key][0]

    BaseFunction.get_call_type = get_call_type  # type: ignore[method-assign]
    try:
        yield
    finally:
        BaseFunction.get_call_type = plain  # type: ignore[method-assign]
