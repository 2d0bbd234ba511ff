// SPDX-License-Identifier: MIT
// Bolan's water in an engine's frame: a window, a sky, lit cubes, a depth buffer of its own, an off-centre projection
// with reversed depth. Page: docs/example-in-your-engine.md.
//
//     04_in_your_engine [--picture FILE.ppm]      with a file: one frame, no waiting
#include "bolan/query.h"
#include "bolan/render.h"

#include <SDL2/SDL.h>
#include <epoxy/gl.h>
#include <stdio.h>
#include <string.h>

#include "04_shaders.h"

enum { WIDTH = 640, HEIGHT = 360, CUBES = 4, SKY_SIDE = 64 };

// ---- the engine -----------------------------------------------------------------------------------------------------

typedef struct cube {
    bolan_dvec3 place; // of its centre, in the world
    float half;        // side [m]
    float albedo[3];
} cube;

// Half under water; before it, behind the waves; over the horizon; wholly under water.
static const cube cubes[CUBES] = {{{0.0, 14.0, 0.0}, 1.5f, {0.8f, 0.1f, 0.1f}},
                                  {{9.0, 60.0, 1.0}, 3.0f, {0.8f, 0.7f, 0.1f}},
                                  {{-7.0, 25.0, 5.0}, 1.5f, {0.1f, 0.6f, 0.2f}},
                                  {{3.6, 9.0, -1.6}, 0.7f, {0.9f, 0.9f, 0.9f}}};

typedef struct engine {
    SDL_Window *window;
    SDL_GLContext context;
    GLuint sky, objects, show, vertices;
    GLuint color, depth, framebuffer; // the engine's own: RGBA16F and a float depth
    GLuint cube_map;                  // its sky, for the water to reflect
    bolan_dvec3 eye;
    bolan_mat4 view, projection;
    bolan_vec3 sun;
} engine;

static GLuint link_program(const char *vertex, const char *fragment) {
    const GLuint program = glCreateProgram();
    for (int i = 0; i < 2; ++i) {
        const char *parts[] = {"#version 330 core\n", i == 0 ? vertex : fragment};
        const GLuint shader = glCreateShader(i == 0 ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
        glShaderSource(shader, 2, parts, NULL);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    return program;
}

static GLint at(GLuint program, const char *name) { return glGetUniformLocation(program, name); }
// Reversed depth, infinite far, and off-centre as one half of a stereo pair is: near over distance, 0 at infinity.
static bolan_mat4 off_centre(float tangent, float aspect, float shift, float near) {
    bolan_mat4 m = {{0.0f}};
    m.m[0] = 1.0f / (tangent * aspect);
    m.m[5] = 1.0f / tangent;
    m.m[8] = shift;
    m.m[11] = -1.0f;
    m.m[14] = near;
    return m;
}

static GLuint texture_of(GLenum format, GLenum components) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)format, WIDTH, HEIGHT, 0, components, GL_FLOAT, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); // no levels
    return name;
}

static void draw_sky(const engine *e, bolan_mat4 to_clip) {
    const bolan_mat4 from_clip = bolan_m4_inverse(to_clip);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(e->sky);
    glUniformMatrix4fv(at(e->sky, "from_clip"), 1, GL_FALSE, from_clip.m);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

// The same sky as a cube map whose face +x looks east, once.
static void make_cube_map(engine *e) {
    // rows of each face's camera, right, up and back in world axes
    static const float faces[6][9] = {{0, 0, -1, 0, -1, 0, -1, 0, 0}, {0, 0, 1, 0, -1, 0, 1, 0, 0},
                                      {1, 0, 0, 0, 0, 1, 0, -1, 0},   {1, 0, 0, 0, 0, -1, 0, 1, 0},
                                      {1, 0, 0, 0, -1, 0, 0, 0, -1},  {-1, 0, 0, 0, -1, 0, 0, 0, 1}};
    GLuint framebuffer = 0;
    glGenTextures(1, &e->cube_map);
    glBindTexture(GL_TEXTURE_CUBE_MAP, e->cube_map);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, SKY_SIDE, SKY_SIDE);
    for (GLenum i = 0; i < 6; ++i) {
        const GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X + i;
        bolan_mat4 view = bolan_m4_identity();
        for (int row = 0; row < 3; ++row)
            for (int axis = 0; axis < 3; ++axis) view.m[4 * axis + row] = faces[i][3 * row + axis];
        glTexImage2D(face, 0, GL_RGBA16F, SKY_SIDE, SKY_SIDE, 0, GL_RGBA, GL_FLOAT, NULL);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, face, e->cube_map, 0);
        draw_sky(e, bolan_m4_mul(off_centre(1.0f, 1.0f, 0.0f, 0.1f), view));
    }
    glDeleteFramebuffers(1, &framebuffer);
}

static bool open_engine(engine *e) {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 4);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 5);
    if (SDL_Init(SDL_INIT_VIDEO) != 0) return false;
    e->window = SDL_CreateWindow("in your engine", 0, 0, WIDTH, HEIGHT, SDL_WINDOW_OPENGL);
    if (!e->window || !(e->context = SDL_GL_CreateContext(e->window))) return false;
    e->sky = link_program(sky_vertex, sky_fragment);
    e->objects = link_program(cube_vertex, cube_fragment);
    e->show = link_program(show_vertex, show_fragment);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE); // for reversed depth
    glGenVertexArrays(1, &e->vertices);
    glBindVertexArray(e->vertices);
    e->color = texture_of(GL_RGBA16F, GL_RGBA);
    e->depth = texture_of(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
    make_cube_map(e);
    glGenFramebuffers(1, &e->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, e->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, e->color, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, e->depth, 0);
    e->eye = (bolan_dvec3){1.0, 0.0, 3.0};
    e->view = bolan_m4_view(0.0, -6.0, 0.0); // looks north, a little down
    e->projection = off_centre(0.42f, (float)WIDTH / HEIGHT, 0.1f, 0.1f);
    e->sun = bolan_v3_normalize(bolan_v3(-0.5f, -0.6f, 0.7f));
    return true;
}

// Sky and cubes into the engine's framebuffer, as they would be without water.
static void draw_opaque(const engine *e) {
    const bolan_mat4 to_clip = bolan_m4_mul(e->projection, e->view); // of eye-relative positions
    glBindFramebuffer(GL_FRAMEBUFFER, e->framebuffer);
    glViewport(0, 0, WIDTH, HEIGHT);
    glDepthMask(GL_TRUE);
    glClearDepth(0.0);
    glClear(GL_DEPTH_BUFFER_BIT);
    draw_sky(e, to_clip);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glUseProgram(e->objects);
    glUniformMatrix4fv(at(e->objects, "to_clip"), 1, GL_FALSE, to_clip.m);
    glUniform3f(at(e->objects, "sun"), e->sun.x, e->sun.y, e->sun.z);
    for (int i = 0; i < CUBES; ++i) {
        const cube *c = &cubes[i];
        glUniform3fv(at(e->objects, "albedo"), 1, c->albedo);
        glUniform4f(at(e->objects, "place"), (float)(c->place.x - e->eye.x), (float)(c->place.y - e->eye.y),
                    (float)(c->place.z - e->eye.z), c->half);
        glDrawArrays(GL_TRIANGLES, 0, 36);
    }
}

// ---- Bolan in it ----------------------------------------------------------------------------------------------------

typedef struct ocean {
    bolan_sea *sea;
    bolan_renderer *renderer;
    bolan_water water;
    bolan_lighting lighting;
} ocean;

static bool open_ocean(ocean *o, const engine *e) {
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(5.0, 240.0, 50e3);
    const bolan_renderer_desc renderer = bolan_renderer_desc_default();
    if (bolan_sea_create(&desc, &o->sea) != BOLAN_OK) return false;
    if (bolan_renderer_create(&renderer, &o->renderer) != BOLAN_OK) return false;
    o->water = bolan_water_default();
    o->water.sea = o->sea;
    o->water.optics = bolan_water_optics_from_jerlov(BOLAN_JERLOV_III);
    o->lighting = bolan_lighting_default(); // with light and haze of the engine's, in its units
    o->lighting.environment.cube = e->cube_map;
    o->lighting.environment.sun_direction = e->sun;
    o->lighting.environment.sun_irradiance = bolan_v3(0.9f, 0.9f, 0.9f);
    o->lighting.haze.kind = BOLAN_HAZE_NONE;
    return true;
}

static void draw_water(const ocean *o, const engine *e) {
    bolan_view view = bolan_view_default();
    view.eye = e->eye;
    view.view = e->view;
    view.projection = e->projection;
    view.zero_to_one = true;
    view.framebuffer = e->framebuffer;
    view.width = WIDTH;
    view.height = HEIGHT;
    view.output = BOLAN_OUTPUT_LINEAR;
    bolan_host host = bolan_host_default();
    host.color = e->color;
    host.depth = e->depth;
    bolan_renderer_prepare(o->renderer, &o->water, &o->lighting); // once a step, for any number of views
    bolan_renderer_draw_water(o->renderer, &view, &host);
}

// ---- the loop -------------------------------------------------------------------------------------------------------

static void show(const engine *e) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, WIDTH, HEIGHT);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(e->show);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, e->color);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

static bool write_picture(const char *path) {
    static unsigned char rgb[HEIGHT][WIDTH][3];
    FILE *file = fopen(path, "wb");
    if (!file) return false;
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, WIDTH, HEIGHT, GL_RGB, GL_UNSIGNED_BYTE, rgb);
    fprintf(file, "P6 %d %d 255\n", WIDTH, HEIGHT);
    for (int row = HEIGHT - 1; row >= 0; --row) fwrite(rgb[row], sizeof rgb[row], 1, file);
    return fclose(file) == 0;
}

int main(int argc, char **argv) {
    const char *picture = argc == 3 && strcmp(argv[1], "--picture") == 0 ? argv[2] : NULL;
    engine e = {0};
    ocean o = {0};
    if (!open_engine(&e)) {
        printf("no window with OpenGL 4.5 here: %s\n", SDL_GetError());
        return 77;
    }
    bool ok = open_ocean(&o, &e);
    for (double time = 30.0; ok; time += 1.0 / 60.0) {
        bolan_sea_step(o.sea, time);
        draw_opaque(&e);
        draw_water(&o, &e);
        show(&e);
        if (picture) ok = write_picture(picture);
        SDL_GL_SwapWindow(e.window);
        if (picture || SDL_QuitRequested()) break;
    }
    bolan_renderer_destroy(&o.renderer);
    bolan_sea_destroy(&o.sea);
    SDL_GL_DeleteContext(e.context);
    SDL_Quit();
    return ok ? 0 : 1;
}
