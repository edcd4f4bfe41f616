# SPDX-License-Identifier: BSD-3-Clause
"""Writes Exodus II files of the classic netCDF formats, without a library of them."""

import struct

BYTE, CHAR, SHORT, INT, FLOAT, DOUBLE = 1, 2, 3, 4, 5, 6
INT64 = 10
FORMATS = {BYTE: "b", SHORT: "h", INT: "i", FLOAT: "f", DOUBLE: "d", INT64: "q"}


def padded(data):
    return data + b"\0" * (-len(data) % 4)


def netcdf(dimensions, variables, version=2):
    """The bytes of a file. `dimensions`: lengths by name, None for the one that grows. `variables`:
    (name, type, names of dimensions, values, texts by name); of those that grow a list of records."""
    count = (lambda n: struct.pack(">q" if version == 5 else ">i", n))
    name = (lambda text: count(len(text)) + padded(text.encode()))
    names = list(dimensions)

    def raw(kind, values):
        if kind == CHAR:
            return values if isinstance(values, bytes) else values.encode()
        return struct.pack(f">{len(values)}{FORMATS[kind]}", *values)

    def grows(variable):
        return bool(variable[2]) and dimensions[variable[2][0]] is None

    data = {v[0]: [padded(raw(v[1], record)) for record in (v[3] if grows(v) else [v[3]])] for v in variables}
    records = max((len(data[v[0]]) for v in variables if grows(v)), default=0)

    def header(begins):
        out = b"CDF" + bytes([version]) + count(records)
        out += struct.pack(">i", 10) + count(len(names))
        out += b"".join(name(n) + count(dimensions[n] or 0) for n in names)
        out += struct.pack(">i", 0) + count(0)
        out += struct.pack(">i", 11) + count(len(variables))
        for v in variables:
            texts = v[4] if len(v) > 4 else {}
            out += name(v[0]) + count(len(v[2])) + b"".join(count(names.index(d)) for d in v[2])
            out += struct.pack(">i", 12 if texts else 0) + count(len(texts))
            for key, text in texts.items():
                out += name(key) + struct.pack(">i", CHAR) + count(len(text)) + padded(text.encode())
            size = len(data[v[0]][0]) if data[v[0]] else 0
            out += struct.pack(">i", v[1]) + count(size)
            out += struct.pack(">i" if version == 1 else ">q", begins.get(v[0], 0))
        return out

    at = len(header({}))
    begins = {}
    body = b""
    for v in sorted(variables, key=grows):
        begins[v[0]] = at
        if grows(v):
            at += len(data[v[0]][0])
        else:
            body += data[v[0]][0]
            at += len(data[v[0]][0])
    for record in range(records):
        body += b"".join(data[v[0]][record] for v in variables if grows(v))
    return header(begins) + body


def exodus(points, blocks, nodal=(), elemental=(), real=DOUBLE, integer=INT, version=2, times=(0.0,),
           names=()):
    """A mesh: points, blocks of (number, type, elements as nodes from 0) and their names, fields at nodes of (name,
    values) and of elements of (name, {number of a block: values}), the same at all times."""
    dims = {"len_string": 33, "time_step": None, "num_dim": len(points[0]), "num_nodes": len(points),
            "num_elem": sum(len(b[2]) for b in blocks), "num_el_blk": len(blocks)}
    variables = [("time_whole", DOUBLE, ["time_step"], [[t] for t in times]),
                 ("eb_prop1", integer, ["num_el_blk"], [b[0] for b in blocks])]
    if names:
        variables.append(("eb_names", CHAR, ["num_el_blk", "len_string"],
                          b"".join(name.encode().ljust(33, b"\0") for name in names)))
    for d, axis in enumerate("xyz"[:len(points[0])]):
        variables.append((f"coord{axis}", real, ["num_nodes"], [p[d] for p in points]))
    for place, (_, kind, elements) in enumerate(blocks, 1):
        dims[f"num_el_in_blk{place}"] = len(elements)
        dims[f"num_nod_per_el{place}"] = len(elements[0])
        variables.append((f"connect{place}", integer, [f"num_el_in_blk{place}", f"num_nod_per_el{place}"],
                          [n + 1 for e in elements for n in e], {"elem_type": kind}))
    for what, fields in (("nod", nodal), ("elem", elemental)):
        if fields:
            dims[f"num_{what}_var"] = len(fields)
            variables.append((f"name_{what}_var", CHAR, [f"num_{what}_var", "len_string"],
                              b"".join(f[0].encode().ljust(33, b"\0") for f in fields)))
    for f, (_, values) in enumerate(nodal, 1):
        variables.append((f"vals_nod_var{f}", real, ["time_step", "num_nodes"], [values for _ in times]))
    for f, (_, of) in enumerate(elemental, 1):
        for place, block in enumerate(blocks, 1):
            if block[0] in of:
                variables.append((f"vals_elem_var{f}eb{place}", real, ["time_step", f"num_el_in_blk{place}"],
                                  [of[block[0]] for _ in times]))
    return netcdf(dims, variables, version)
