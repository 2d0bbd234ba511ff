# SPDX-License-Identifier: MIT
# awk -f layers.awk FILES: the layer rules over all sources. Exit 1 if any is broken.

BEGIN {
    # Modules and what each may include besides itself. Data flows one way, and so do includes.
    may["base"] = ""
    may["math"] = "base"
    may["params"] = "base math"
    may["earth"] = may["optics"] = may["fft"] = "base math params"
    may["spectrum"] = "base math params earth"
    may["formats"] = "base math params earth spectrum"
    may["ground"] = "base math params"
    may["coast"] = "base math params ground"
    may["waves"] = "base math params spectrum fft"
    may["record"] = "base math params spectrum"
    may["flow"] = may["waves"] " waves"
    may["surface"] = may["body"] = may["tiles"] = "base math params earth spectrum optics fft waves"
    may["water"] = "base math params earth spectrum optics waves flow ground coast"
    may["query"] = may["water"] " fft water"
    may["model"] = "base math params ground"
    core = "base math params earth spectrum formats optics fft ground coast waves flow record surface body tiles water query model"
    may["technique"] = "base math params spectrum waves surface"
    may["content"] = "base math params ground model"
    may["scene"] = core " technique"
    may["world"] = core " technique scene"
    may["render_context"] = "base"
    may["io"] = core " technique scene world" # it and render do not know each other
    may["render"] = may["io"] " render_context"
    may["io"] = may["io"] " content" # scene files name generated grounds and models
    may["export"] = may["io"]
    may["io"] = may["io"] " export" # src/io writes exports too
    may["bolan"] = may["io"] " io"                    # the umbrella header: never GL

    c_headers = "assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign stdarg " \
        "stdatomic stdbool stddef stdint stdio stdlib stdnoreturn string tgmath threads time uchar wchar wctype"
    posix_headers = "dirent fcntl poll pthread sched strings sys/mman sys/resource sys/stat sys/time sys/types sys/wait " \
        "termios unistd sys/ioctl cpuid immintrin arm_neon"
    public_headers = "math stdbool stddef stdint"
    for (i = 1; i < ARGC; i++) exists[ARGV[i]] = 1

    # The GL folder's interface has no OpenGL header (checked below), so what GL_ names it holds are its own.
    while ((getline line < "src/render/gl/gl.h") > 0)
        for (; match(line, /GL_[A-Z0-9_]+/); line = substr(line, RSTART + RLENGTH)) ours[substr(line, RSTART, RLENGTH)] = 1
}

FNR == 1 { in_comment = 0; enter(FILENAME) }

{
    code = strip_comments($0)
    if (code ~ /^[ \t]*#[ \t]*include[ \t]*</) { check_system(between(code, "<", ">")); next }
    if (code ~ /^[ \t]*#[ \t]*include[ \t]*"/) { check_own(between(code, "\"", "\"")); next }
    gsub(/"([^"\\]|\\.)*"/, "\"\"", code)
    if (code ~ /^ *X\([0-9]+, /) next # the log table
    if (!gl_allowed) check_names(" " code)
}

END {
    for (path in files) count++
    print count " files, " breaches + 0 " breaches of the layers"
    exit breaches > 0
}

# Who is this file? `area`: include, src, shaders (shared alone), apps or examples; `module` in the first two.
function enter(path, parts) {
    files[path] = 1
    split(path, parts, "/")
    area = parts[1]
    module = area == "include" ? parts[3] : area == "src" ? parts[2] : ""
    sub(/\.h$/, "", module)
    engine = path ~ /^examples\/04_/ # an engine has OpenGL and a window of its own
    gl_allowed = path ~ /^src\/render\/gl\// || engine
    viewer = path ~ /^apps\/viewer\//
    if (module != "" && !(module in may)) breach("a module that the layers do not name: " module)
}

function check_system(header, name) {
    name = header
    sub(/\.h$/, "", name)
    if (area == "include") {
        if (!has(public_headers, name)) breach("a public header shows <" header ">")
        return
    }
    if (has(c_headers, name) || has(posix_headers, name)) return
    if (FILENAME ~ /\.cpp$/ && has(c_headers, substr(name, 2))) return # <cmath>
    if (gl_allowed && FILENAME !~ /\/gl\.h$/ && header ~ /^(epoxy|EGL|GL|GLES3)\//) return
    if (area == "src" && module == "io" && header !~ /^(epoxy|EGL|GL|GLES|SDL)/) return
    if (engine && header ~ /^SDL2\//) return
    if (FILENAME ~ /^apps\/bolan\// && has("spawn sys/prctl sys/socket", name)) return
    if (FILENAME ~ /^apps\/bolan\/mpi\// && header == "mpi.h") return
    if (FILENAME ~ /^apps\/web\// && header ~ /^emscripten\//) return
    if (viewer && header ~ /^(SDL|imgui|backends\/imgui_impl_(sdl|opengl3))/) return
    breach("<" header "> is not for this layer")
}

function check_own(header, path, other, line) {
    if (header ~ /^bolan\//) {
        other = substr(header, 7)
        sub(/\.h$/, "", other)
        if (!exists["include/" header]) breach("there is no public header " header)
        else if (module == "") return # apps and examples: any public header
        else if (other == "bolan") breach("the library includes its own umbrella")
        else check_module(other, header)
        return
    }
    if (header ~ /^shared\/[a-z_]+\.glsl$/) { # C and GLSL: constants and pure functions, for every module of src/
        if (area != "src" && area != "shaders") breach(area "/ includes \"" header "\", which is not public")
        else if ((getline line < ("shaders/" header)) < 0) breach("cannot find \"" header "\"")
        close("shaders/" header)
        return
    }
    path = resolve(header)
    if (path == "") breach("cannot find \"" header "\"")
    else if (area == "include") breach("a public header includes the private \"" header "\"")
    else if (path ~ /^src\//) {
        if (area != "src") breach(area "/ includes \"" header "\", which is not public")
        else { split(path, own_parts, "/"); check_module(own_parts[2], header) }
    } else if (area != "apps" || path !~ /^apps\//) {
        if (path !~ "^" area "/") breach("\"" header "\" is not for this layer")
    }
}

function check_module(other, header) {
    if (other != module && !has(may[module], other)) breach(module " may not include \"" header "\" of " other)
}

function check_names(code, name) {
    while (match(code, /[^A-Za-z0-9_](gl[A-Z][A-Za-z0-9]+|GL[a-z]+|GL_[A-Z0-9_]+|egl[A-Z][A-Za-z0-9]+|EGL[A-Za-z0-9_]*)/)) {
        name = substr(code, RSTART + 1, RLENGTH - 1)
        code = substr(code, RSTART + RLENGTH)
        if (!(name in ours)) breach("the OpenGL name " name " stands outside src/render/gl/")
    }
}

# The file that a quoted include means: beside the includer, else under src/.
function resolve(header, folder, path) {
    folder = FILENAME
    sub(/[^\/]*$/, "", folder)
    path = normal(folder header)
    if (path in exists) return path
    if (("src/" header) in exists) return "src/" header
    if (area == "apps" && ("apps/bolan/" header) in exists) return "apps/bolan/" header
    if (area == "apps" && ("apps/viewer/" header) in exists) return "apps/viewer/" header
    return ""
}

function normal(path) {
    while (path ~ /[^\/.]+\/\.\.\//) sub(/[^\/.]+\/\.\.\//, "", path)
    return path
}

function between(text, left, right) {
    text = substr(text, index(text, left) + 1)
    return substr(text, 1, index(text, right) - 1)
}

function has(list, word) { return index(" " list " ", " " word " ") > 0 }

function strip_comments(line, at) {
    if (in_comment) {
        at = index(line, "*/")
        if (!at) return ""
        line = substr(line, at + 2)
        in_comment = 0
    }
    gsub(/\/\*([^*]|\*[^\/])*\*\//, " ", line)
    sub(/\/\/.*$/, "", line)
    at = index(line, "/*")
    if (at) { in_comment = 1; line = substr(line, 1, at - 1) }
    return line
}

function breach(what) {
    print FILENAME ":" FNR ": " what
    breaches++
}
