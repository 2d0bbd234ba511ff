// SPDX-License-Identifier: MIT
// bolan info: features of this build and this machine.
#include "commands.h"
#include "completion.h"
#include "describe.h"
#include "help.h"
#include "info_spectra.h"
#include "man.h"
#include "options.h"

#include "bolan/io.h"
#include "bolan/render.h"

#include <string.h>
#include <unistd.h>

// GCC's __VERSION__ is a bare number.
#if defined(__clang__)
static const char compiler[] = "Clang " __clang_version__;
#elif defined(__GNUC__)
static const char compiler[] = "GCC " __VERSION__;
#else
static const char compiler[] = "an unknown compiler";
#endif

static char gl_message[2048];

// Where OpenGL is missing, the reason is part of the output and not an error.
static void keep_message(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level, (void)id;
    snprintf(gl_message, sizeof gl_message, "%s", sentence);
}

typedef struct facts {
    long processors;
    bolan_gl_info gl;
    bool has_gl;
} facts;

static const char *yes_or_no(bool yes) { return yes ? "yes" : "no"; }

// Memory of a scene's sea.
static size_t sea_bytes(const bolan_scene *scene) {
    const bolan_sea_bytes bytes = bolan_sea_size(&scene->sea);
    return bytes.tables + bytes.fields;
}

static void print_text(const facts *f) {
    printf("bolan %s, compiled by %s\n", bolan_version(), compiler);
    printf("processors   %ld; wide kernels:", f->processors);
    for (int cpu = BOLAN_CPU_SCALAR; cpu <= (int)bolan_cpu_best(); cpu++) printf(" %s", bolan_cpu_name((bolan_cpu)cpu));
    if (f->has_gl) {
        printf("\nOpenGL       %s\n             %s, GLSL %s%s%s\n", f->gl.version, f->gl.renderer,
               f->gl.shading_language, f->gl.software ? " (software)" : "", f->gl.compute ? ", compute shaders" : "");
    } else {
        printf("\nOpenGL       none: %s\n", gl_message);
    }
    const bolan_io_features io = bolan_io_get_features();
    printf("files        rasters: %s; models: %s; EXR: %s; gzip: %s; NetCDF-4: %s\n", yes_or_no(io.rasters),
           yes_or_no(io.models), yes_or_no(io.exr), yes_or_no(io.gzip), yes_or_no(io.netcdf4));
    uint32_t count = 0;
    const bolan_technique *techniques = bolan_techniques(&count);
    printf("techniques   waves x surface x optics\n");
    for (uint32_t i = 0; i < count; i++)
        printf("  %-12s %s x %s x %s\n", techniques[i].name, bolan_wave_model_names[techniques[i].waves],
               bolan_surface_kind_names[techniques[i].surface], bolan_optics_kind_names[techniques[i].optics]);
    printf("scenes\n");
    for (uint32_t i = 0; bolan_scene_builtin_name(i); i++) {
        bolan_scene scene;
        if (bolan_scene_load(bolan_scene_builtin_name(i), &scene) != BOLAN_OK) continue;
        printf("  %-10s %s (sea: %.1f MB)\n", scene.name, scene.description, 1e-6 * (double)sea_bytes(&scene));
    }
}

static void print_quoted(const char *text) {
    putchar('"');
    for (; *text; text++) {
        if (*text == '"' || *text == '\\') putchar('\\');
        if ((unsigned char)*text >= 32) putchar(*text);
    }
    putchar('"');
}

// What is built in or lies beside the program.
static void print_json_build(void) {
#ifdef BOLAN_HAVE_VIEWER
    const bool viewer = true;
#else
    const bool viewer = false;
#endif
    const bolan_io_features io = bolan_io_get_features();
    printf(",\n  \"viewer\": %s,\n  \"bench\": %s", viewer ? "true" : "false", bench_is_there() ? "true" : "false");
    printf(",\n  \"files\": {\"rasters\": %s, \"models\": %s, \"exr\": %s, \"gzip\": %s, \"netcdf4\": %s}",
           io.rasters ? "true" : "false", io.models ? "true" : "false", io.exr ? "true" : "false",
           io.gzip ? "true" : "false", io.netcdf4 ? "true" : "false");
}

static void print_json(const facts *f) {
    printf("{\n  \"version\": \"%s\",\n  \"compiler\": ", bolan_version());
    print_quoted(compiler);
    printf(",\n  \"processors\": %ld,\n  \"cpu\": [", f->processors);
    for (int cpu = BOLAN_CPU_SCALAR; cpu <= (int)bolan_cpu_best(); cpu++)
        printf("%s\"%s\"", cpu > BOLAN_CPU_SCALAR ? ", " : "", bolan_cpu_name((bolan_cpu)cpu));
    printf("],\n  \"gl\": ");
    if (f->has_gl) {
        printf("{\"version\": ");
        print_quoted(f->gl.version);
        printf(", \"renderer\": ");
        print_quoted(f->gl.renderer);
        printf(", \"software\": %s, \"compute\": %s}", f->gl.software ? "true" : "false",
               f->gl.compute ? "true" : "false");
    } else {
        printf("null");
    }
    print_json_build();
    uint32_t count = 0;
    const bolan_technique *techniques = bolan_techniques(&count);
    printf(",\n  \"techniques\": [");
    for (uint32_t i = 0; i < count; i++) printf("%s\"%s\"", i ? ", " : "", techniques[i].name);
    printf("],\n  \"scenes\": [");
    for (uint32_t i = 0; bolan_scene_builtin_name(i); i++)
        printf("%s\"%s\"", i ? ", " : "", bolan_scene_builtin_name(i));
    printf("],\n  \"sea_bytes\": {");
    for (uint32_t i = 0; bolan_scene_builtin_name(i); i++) {
        bolan_scene scene;
        const bool ok = bolan_scene_load(bolan_scene_builtin_name(i), &scene) == BOLAN_OK;
        printf("%s\"%s\": %zu", i ? ", " : "", bolan_scene_builtin_name(i), ok ? sea_bytes(&scene) : (size_t)0);
    }
    printf("}\n}\n");
}

int command_info(int count, char **arguments) {
    options o;
    const int result = options_parse(ON_INFO, "info", count, arguments, &o);
    if (result) return result;
    if (o.help)
        return help_command(ON_INFO, "info [FILE] [OPTIONS]",
                            "Prints what this build and this machine can do, or what a file of spectra holds.");
    if (o.scene) return info_spectra(&o);
    if (option_given(&o, "record") || option_given(&o, "location") || option_given(&o, "interpolate") ||
        option_given(&o, "from") || option_given(&o, "spread"))
        return usage_error("bolan info has no file of spectra to choose from; expected bolan info FILE");
    if (o.parameters || o.schema || o.man || o.completion >= 0) {
        if (o.parameters) describe_print_tables(stdout);
        if (o.schema) describe_print_schema(stdout);
        if (o.man) man_print(stdout);
        if (o.completion >= 0) completion_print(stdout, o.completion);
        return EXIT_OK;
    }
    bolan_set_hooks(&(bolan_hooks){.log = keep_message});
    bolan_context *context = NULL;
    facts f = {.processors = sysconf(_SC_NPROCESSORS_ONLN)};
    f.has_gl = bolan_context_create(BOLAN_GL_CORE, &context) == BOLAN_OK;
    if (f.has_gl) f.gl = bolan_gl_get_info();
    if (o.json) {
        print_json(&f);
    } else {
        print_text(&f);
    }
    bolan_context_destroy(&context);
    return EXIT_OK;
}
