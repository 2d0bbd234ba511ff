#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Makes the generated files of the package from the public headers.

usage: generate.py HEADERS FOLDER

HEADERS is the folder that holds bolan/*.h. Into FOLDER, normally bindings/python/bolan, go
  _declarations.h  what cffi is told: the headers after the preprocessor, without inline functions
  _abi.py          the same, compiled by cffi for its ABI mode, so that importing parses nothing
  _structs.py      a class for each struct, with the headers' comments
  _docs.py         the headers' comments of each function
The compiler is $CC, or cc.
"""
import keyword
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import cffi

HEADERS = ("bolan/bolan.h", "bolan/render.h")
NOTE = "SPDX-License-Identifier: MIT\nMade by bindings/python/generate.py from include/bolan/*.h. Do not edit."
# Vectors are tuples in Python.
TUPLES = ("bolan_vec2", "bolan_vec3", "bolan_vec4", "bolan_dvec2", "bolan_dvec3")


def comment(mark):
    return "".join(f"{mark} {line}\n" for line in NOTE.splitlines())


# ---- declarations --------------------------------------------------------------------------------------------------

def declarations(include):
    """The declarations of the public headers as text for cffi."""
    with tempfile.TemporaryDirectory() as empty:
        # cffi knows bool, size_t and the integers of stdint.h; the rest of these headers is not needed.
        for name in ("math", "stdbool", "stddef", "stdint"):
            pathlib.Path(empty, name + ".h").touch()
        source = "".join(f'#include "{header}"\n' for header in HEADERS)
        # Without __GNUC__ the headers have no attributes.
        command = [*os.environ.get("CC", "cc").split(), "-E", "-P", "-nostdinc", "-U__GNUC__", "-I", str(include), "-I",
                   empty, "-x", "c", "-"]
        text = subprocess.run(command, input=source, capture_output=True, text=True, check=True).stdout
    text = re.sub(r"static inline [^{;]*\{[^}]*\}", "", text)
    text = re.sub(r"\s+", " ", text)
    # One declaration a line, so that a difference can be read; enumerators and fields stay beside each other.
    lines, depth, line = [], 0, ""
    for character in text:
        line += character
        depth += {"{": 1, "}": -1}.get(character, 0)
        if character == ";" and depth == 0:
            lines.append(line.strip())
            line = ""
    return comment("//") + "\n".join(lines) + "\n"


def abi(text):
    """cffi's form of the declarations."""
    ffi = cffi.FFI()
    ffi.cdef(without_comments(text))
    ffi.set_source("bolan._abi", None)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "_abi.py")
        ffi.emit_python_code(str(path))
        made = path.read_text()
    return comment("#") + made.replace("# auto-generated file\n", "")


def without_comments(text):
    return re.sub(r"^//.*$", "", text, flags=re.M)


# ---- comments ------------------------------------------------------------------------------------------------------

def plain(lines):
    """Text of a doc comment without the marks of doxygen."""
    text = "\n".join(lines)
    text = re.sub(r"@(code|endcode)\n?", "", text)
    text = re.sub(r"@param (\w+)", r"\1:", text)
    text = re.sub(r"@p (\w+)", r"\1", text)
    text = re.sub(r"@ref (?:\w+::)?(\w+)", r"\1", text)
    text = re.sub(r"(?<!\w)::(?=\w)", "", text)
    text = text.replace("&lt;", "<").replace("&gt;", ">")
    return text.replace("\\", "\\\\").replace('"""', "'''").strip()


def read_comments(include):
    """Comments of functions by name, of structs by name, and of fields by (struct, field)."""
    functions, structs, fields = {}, {}, {}
    for path in sorted(pathlib.Path(include, "bolan").glob("*.h")):
        above, struct, depth, declaration = [], None, 0, ""
        for line in path.read_text().splitlines():
            stripped = line.strip()
            if stripped.startswith("///") and not declaration:
                above.append(stripped[3:].removeprefix(" "))
                continue
            code = stripped.split("//")[0].strip()
            if not code or code.startswith(("#", 'extern "C"')) or code.endswith("\\"):
                if not code and not stripped:
                    above = []
                continue
            started = re.match(r"typedef struct (bolan_\w+) \{", code)
            if started and struct is None:
                struct, depth = started[1], 1
                structs[struct] = plain(above)
                above = []
                continue
            if struct:
                was, depth = depth, depth + code.count("{") - code.count("}")
                if depth == 0:
                    struct = None
                elif depth == 1 and was == 1:
                    for name in field_names(code):
                        fields[struct, name] = plain(above)
                elif depth == 2 and was == 1:
                    inner = above
                elif depth == 1 and was == 2:
                    fields[struct, re.match(r"\} *(\w+)", code)[1]] = plain(inner)
                above = []
                continue
            declaration += " " + code
            if code.endswith((";", "}")):
                named = re.search(r"\b(bolan_\w+)\(", declaration)
                if named and above:
                    functions[named[1]] = plain(above)
                above, declaration = [], ""
    return functions, structs, fields


def field_names(code):
    if "(*" in code:
        return [re.search(r"\(\*(\w+)\)", code)[1]]
    names = re.sub(r"\[[^\]]*\]", "", code.rstrip(";")).split(",")
    return [re.search(r"(\w+)$", name.strip())[1] for name in names]


# ---- classes -------------------------------------------------------------------------------------------------------

def class_name(struct):
    return "".join(part.capitalize() for part in struct.removeprefix("bolan_").split("_"))


def python_name(field):
    return field + "_" if keyword.iskeyword(field) else field


def annotation(kind):
    """The Python type that a field of this C type reads as."""
    if kind.kind == "enum":
        return "str"
    if kind.kind == "primitive":
        return {"double": "float", "float": "float", "_Bool": "bool"}.get(kind.cname, "int")
    if kind.kind == "struct":
        if kind.cname in TUPLES:
            return "Tuple[float, ...]"
        return f'"{class_name(kind.cname)}"' if kind.cname.startswith("bolan_") else "Struct"
    if kind.kind == "array":
        return "str" if kind.item.cname == "char" else f"Tuple[{annotation(kind.item)}, ...]"
    if kind.kind == "pointer" and kind.item.cname == "char":
        return "Optional[str]"
    return "Any"


def struct_classes(text, structs, fields):
    ffi = cffi.FFI()
    ffi.cdef(without_comments(text))
    out = [comment("#"), '"""The plain structs of the C headers. Fields read and write the memory of the struct."""\n',
           "from typing import Any, Optional, Tuple\n\nfrom ._struct import Struct\n"]
    for name in sorted(structs):
        kind = ffi.typeof(name)
        if name in TUPLES or kind.fields is None:
            continue
        lines = [f'\n\nclass {class_name(name)}(Struct):\n    """{structs[name]}\n\n    Fields:\n']
        for field, described in kind.fields:
            doc = fields.get((name, field), "")
            lines.append(f"    {field}: " + doc.replace("\n", "\n        ").rstrip() + "\n")
        lines.append('    """\n' + f'    _type = "{name}"\n')
        for field, described in kind.fields:
            lines.append(f"    {python_name(field)}: {annotation(described.type)}\n")
        out.append("".join(re.sub(r"[ \t]+\n", "\n", line) for line in lines))
    return "".join(out)


def function_docs(functions):
    out = [comment("#"), '"""Comments of the functions of the C headers."""\n\nDOCS = {\n']
    for name in sorted(functions):
        out.append(f'    "{name}": """{functions[name]}""",\n')
    return "".join(out) + "}\n"


def generate(include):
    """The generated files by name."""
    text = declarations(include)
    functions, structs, fields = read_comments(include)
    return {"_declarations.h": text, "_abi.py": abi(text), "_structs.py": struct_classes(text, structs, fields),
            "_docs.py": function_docs(functions)}


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: generate.py HEADERS FOLDER")
    for name, text in generate(sys.argv[1]).items():
        pathlib.Path(sys.argv[2], name).write_text(text)


if __name__ == "__main__":
    main()
