# SPDX-License-Identifier: BSD-3-Clause
"""Writes HDF5 files through the C library, without h5py.

    with Writer(path) as file:
        file.group("/a")
        file.attribute("/a", "Version", np.array([2, 0]))
        file.dataset("/a/x", np.zeros((3, 2)), chunk=2)
"""

import ctypes
import ctypes.util

import numpy as np

FOUND = ctypes.util.find_library("hdf5_serial") or ctypes.util.find_library("hdf5")
LIBRARY = ctypes.CDLL(FOUND) if FOUND else None

Id = ctypes.c_int64
TYPES = {"<f8": "IEEE_F64LE", ">f8": "IEEE_F64BE", "<f4": "IEEE_F32LE", ">f4": "IEEE_F32BE", "<i8": "STD_I64LE",
         "<i4": "STD_I32LE", "<i2": "STD_I16LE", "|i1": "STD_I8LE", "<u8": "STD_U64LE", "<u4": "STD_U32LE",
         "<u2": "STD_U16LE", "|u1": "STD_U8LE", ">i4": "STD_I32BE", ">i8": "STD_I64BE"}


def call(name, *arguments):
    """A function of the library, whose integers are all passed as such of 64 bits."""
    function = getattr(LIBRARY, name)
    function.restype = Id
    done = function(*arguments)
    # Functions that return an int have no meaning in the upper half.
    if ctypes.c_int32(done & 0xFFFFFFFF).value < 0:
        raise OSError(f"{name} failed")
    return done


class Writer:
    """A new file."""

    def __init__(self, path):
        call("H5open")
        self.file = Id(call("H5Fcreate", str(path).encode(), ctypes.c_uint(2), Id(0), Id(0)))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        call("H5Fclose", self.file)

    def group(self, path):
        call("H5Gclose", Id(call("H5Gcreate2", self.file, path.encode(), Id(0), Id(0), Id(0))))

    def attribute(self, path, name, value):
        """`value`: numbers, a text, or a list of texts; texts are padded to the longest one."""
        values, kind = prepared(value)
        space = self.space(values)
        owner = Id(call("H5Oopen", self.file, path.encode(), Id(0)))
        made = Id(call("H5Acreate2", owner, name.encode(), kind, space, Id(0), Id(0)))
        call("H5Awrite", made, kind, values.ctypes.data_as(ctypes.c_void_p))
        call("H5Aclose", made)
        call("H5Oclose", owner)
        call("H5Sclose", space)

    def dataset(self, path, value, chunk=None):
        """`chunk`: rows of a compressed block."""
        values, kind = prepared(value)
        space = self.space(values)
        options = Id(0)
        if chunk and values.size:
            options = Id(call("H5Pcreate", Id(Id.in_dll(LIBRARY, "H5P_CLS_DATASET_CREATE_ID_g").value)))
            extent = (ctypes.c_uint64 * values.ndim)(min(chunk, len(values)), *values.shape[1:])
            call("H5Pset_chunk", options, ctypes.c_int(values.ndim), extent)
            call("H5Pset_deflate", options, ctypes.c_uint(4))
        made = Id(call("H5Dcreate2", self.file, path.encode(), kind, space, Id(0), options, Id(0)))
        if values.size:
            call("H5Dwrite", made, kind, Id(0), Id(0), Id(0), values.ctypes.data_as(ctypes.c_void_p))
        call("H5Dclose", made)
        call("H5Sclose", space)

    def link(self, path, target):
        call("H5Lcreate_soft", target.encode(), self.file, path.encode(), Id(0), Id(0))

    @staticmethod
    def space(values):
        if values.ndim == 0:
            return Id(call("H5Screate", ctypes.c_int(0)))
        extent = (ctypes.c_uint64 * values.ndim)(*values.shape)
        return Id(call("H5Screate_simple", ctypes.c_int(values.ndim), extent, None))


def prepared(value):
    """The values as an array, and the library's type of them."""
    if isinstance(value, str) or (isinstance(value, list) and value and isinstance(value[0], str)):
        values = np.array(value, dtype="S") if isinstance(value, list) else np.array(value.encode())
        kind = Id(call("H5Tcopy", Id(Id.in_dll(LIBRARY, "H5T_C_S1_g").value)))
        call("H5Tset_size", kind, ctypes.c_size_t(max(values.dtype.itemsize, 1)))
        call("H5Tset_strpad", kind, ctypes.c_int(1))
        return values, kind
    values = np.asarray(value)
    values = values if values.flags["C_CONTIGUOUS"] else values.copy()
    name = f"H5T_{TYPES[values.dtype.str]}_g"
    return values, Id(Id.in_dll(LIBRARY, name).value)
