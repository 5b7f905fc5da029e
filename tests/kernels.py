"""Kernels of tests are compiled by child processes: the compiler keeps some 30 MB of each until its process ends.

A suite of thirty kernels would hold 1.3 GB a process, where reading the kept kernels takes 4 MB each.
"""

import os

from numba.core.caching import FunctionCache
from numba.core.dispatcher import Dispatcher

_compile = Dispatcher.compile


def _kept(dispatcher: Dispatcher, signature) -> bool:
    cache = dispatcher._cache
    key = cache._index_key(signature, dispatcher.targetctx.codegen())
    return key in cache._cache_file._load_index()


def compile_in_a_child(dispatcher: Dispatcher, signature):
    """Have a child compile what is not kept yet; then read it, or meet the same error."""
    if isinstance(dispatcher._cache, FunctionCache) and not _kept(dispatcher, signature):
        child = os.fork()
        if child == 0:
            Dispatcher.compile = _compile
            try:
                _compile(dispatcher, signature)
            finally:
                os._exit(0)
        os.waitpid(child, 0)
    return _compile(dispatcher, signature)


def save_memory() -> None:
    """Compile all kernels of this process in children, where the system can fork."""
    if hasattr(os, "fork"):
        Dispatcher.compile = compile_in_a_child
