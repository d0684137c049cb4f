"""The files in which numba keeps compiled code, made so that damage to them costs time and nothing else.

numba reads a cut or empty file as it is: unpickling fails, in every later process, until somebody removes the file. And code
that a power cut has replaced by zeros would be executed. Here each file of code ends in a checksum. What cannot be read is
thrown away, compiled again and written anew; what cannot be written is compiled again in the next process.
"""

from __future__ import annotations

import contextlib
import pickle
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

from numba.core.caching import FunctionCache, IndexDataCacheFile

_CRC_BYTES = 4


class _CheckedFiles(IndexDataCacheFile):
    """numba's index and data files, with a CRC-32 at the end of what is pickled."""

    def _dump(self, value: Any) -> bytes:
        data: bytes = super()._dump(value)
        return data + _crc(data)

    def _load_data(self, name: str) -> Any:
        content = Path(self._data_path(name)).read_bytes()
        data, crc = content[:-_CRC_BYTES], content[-_CRC_BYTES:]
        if crc != _crc(data):
            raise ValueError(f"{name} is damaged")
        return pickle.loads(data)


class CodeCache(FunctionCache):
    """The compiled code of one function, on disk.

    Args:
        folder: one that belongs to the contents of all sources. In it the code is found again whatever the path and the time of
            the source file, as after an installation anew. None: where numba looks for it, by path and time.
    """

    def __init__(self, function: Callable[..., Any], folder: Path | None = None) -> None:
        super().__init__(function)
        stamp = self._cache_file._source_stamp
        if folder is not None:
            self._cache_path, stamp = str(folder / function.__module__), ()
            with contextlib.suppress(OSError):
                Path(self._cache_path).mkdir(exist_ok=True)
        self._cache_file = _CheckedFiles(self._cache_path, self._impl.filename_base, stamp)

    def load_overload(self, signature: Any, target_context: Any) -> Any:
        """The code for a signature; None if there is none, or none that can be read."""
        try:
            return super().load_overload(signature, target_context)
        except Exception:  # of pickle, of numba, or of what was unpickled: a damaged file can raise anything
            with contextlib.suppress(OSError):
                self.flush()
            return None

    def save_overload(self, signature: Any, code: Any) -> None:
        """Keep the code for a signature; without effect where nothing can be written, as on a full disk."""
        with contextlib.suppress(OSError):
            super().save_overload(signature, code)


def _crc(data: bytes) -> bytes:
    return zlib.crc32(data).to_bytes(_CRC_BYTES, "little")
