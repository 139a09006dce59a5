#!/usr/bin/env python3
"""Compiles HLSL with Microsoft's compiler from its shared library: dxc.py LIBRARY SOURCE OUTPUT [option ...]

The options are those of the command dxc, for example -T cs_6_0 -E main -spirv. Messages go to stderr; exit code 1 if
the source is refused. The library (libdxcompiler, Linux) speaks COM: an object is a pointer to a table of functions.
"""
import ctypes as c
import os
import sys
import uuid
from pathlib import Path

# QueryInterface, AddRef, Release and this build's virtual destructor (two entries) come before an interface's own.
FIRST = 5


def call(this, index, *arguments, result=c.c_int32):
    table = c.cast(this, c.POINTER(c.POINTER(c.c_void_p))).contents
    return c.CFUNCTYPE(result, c.c_void_p, *map(type, arguments))(table[FIRST + index])(this, *arguments)


def blob(this):
    if not this:
        return b""
    size = call(this, 1, result=c.c_size_t)
    return c.string_at(call(this, 0, result=c.c_void_p), size) if size else b""


def identity(text):
    return c.create_string_buffer(uuid.UUID(text).bytes_le, 16)


class Buffer(c.Structure):
    _fields_ = [("pointer", c.c_char_p), ("size", c.c_size_t), ("encoding", c.c_uint32)]


def main(library, source, output, *options):
    create = c.CDLL(library).DxcCreateInstance
    compiler, result, part, status = c.c_void_p(), c.c_void_p(), c.c_void_p(), c.c_int32()
    class_id = identity("73e22d93-e6ce-47f3-b5bf-f0664f39c1b0")
    if create(class_id, identity("228B4687-5A6A-4730-900C-9702B2203F54"), c.byref(compiler)):
        sys.exit(f"{library} holds no IDxcCompiler3")
    text = Path(source).read_bytes()
    words = (c.c_wchar_p * len(options))(*options)
    call(compiler, 0, c.pointer(Buffer(text, len(text), 65001)), words, c.c_uint32(len(options)), c.c_void_p(),
         identity("58346CDA-DDE7-4497-9461-6F87AF5E0659"), c.pointer(result))
    call(result, 0, c.pointer(status))
    call(result, 2, c.pointer(part))
    sys.stderr.write(blob(part).rstrip(b"\0").decode())
    if not status.value:
        call(result, 1, c.pointer(part))
        Path(output).write_bytes(blob(part))
    sys.stderr.flush()
    # Without the library's finalisers, which may wait for themselves for ever.
    os._exit(1 if status.value else 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
