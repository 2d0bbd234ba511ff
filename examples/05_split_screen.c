// SPDX-License-Identifier: MIT
// Two players on one sea: a step is prepared once and drawn from two views, side by side in one framebuffer.
// Page: docs/example-split-screen.md.
//
//     05_split_screen [FILE.png]
#include "bolan/io.h"
#include "bolan/render.h"
#include "bolan/world.h"

#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 640, HEIGHT = 240, PLAYERS = 2, BYTES = WIDTH * HEIGHT * 3 };

typedef struct game {
    bolan_world *world;
    bolan_renderer *renderer;
    bolan_target *target;
    bolan_view_cache *cache[PLAYERS]; // their eyes are far apart: each keeps its own tables of the sky
    uint8_t *both, *alone;            // the picture, and one in which a single player is drawn
} game;

static bool open_game(game *g) {
    const bolan_renderer_desc desc = bolan_renderer_desc_default();
    bool ok = bolan_world_load("open-sea", &g->world) == BOLAN_OK;
    ok = ok && bolan_renderer_create(&desc, &g->renderer) == BOLAN_OK;
    ok = ok && bolan_target_create(WIDTH, HEIGHT, &g->target) == BOLAN_OK;
    for (int i = 0; i < PLAYERS; ++i) ok = ok && bolan_view_cache_create(g->renderer, &g->cache[i]) == BOLAN_OK;
    g->both = ok ? bolan_allocate(BYTES) : NULL;
    g->alone = ok ? bolan_allocate(BYTES) : NULL;
    return g->both != NULL && g->alone != NULL;
}

static void close_game(game *g) {
    bolan_release(g->both, BYTES);
    bolan_release(g->alone, BYTES);
    for (int i = 0; i < PLAYERS; ++i) bolan_view_cache_destroy(&g->cache[i]);
    bolan_target_destroy(&g->target);
    bolan_renderer_destroy(&g->renderer);
    bolan_world_destroy(&g->world);
}

// Player 0 looks west from a boat, player 1 down from a cliff 3 km away; each into a half of the framebuffer.
static bolan_view view_of(const game *g, int player) {
    bolan_view view = bolan_view_default();
    view.eye = player == 0 ? (bolan_dvec3){0.0, 0.0, 4.0} : (bolan_dvec3){3000.0, 800.0, 60.0};
    view.view = player == 0 ? bolan_m4_view(270.0, -3.0, 0.0) : bolan_m4_view(200.0, -20.0, 0.0);
    view.x = player == 0 ? 0 : WIDTH / 2;
    view.width = WIDTH / 2;
    view.height = HEIGHT;
    view.projection = bolan_m4_projection(bolan_radians(50.0), (double)view.width / view.height, 0.1, 0);
    view.framebuffer = bolan_target_framebuffer(g->target);
    view.cache = g->cache[player];
    return view;
}

static void draw(game *g, int first, int last, uint8_t *rgb) {
    for (int i = first; i <= last; ++i) {
        const bolan_view view = view_of(g, i);
        bolan_renderer_draw_world(g->renderer, g->world, &view); // an unchanged step is not uploaded again
    }
    bolan_renderer_read_rgb8(g->renderer, bolan_target_framebuffer(g->target), WIDTH, HEIGHT, rgb);
}

// Number of bytes of a player's half that differ from a renderer that draws this player alone.
static int differences(const game *g, int player) {
    int count = 0;
    for (int i = 0; i < BYTES; ++i)
        count += i / 3 % WIDTH / (WIDTH / 2) == player && g->both[i] != g->alone[i];
    return count;
}

int main(int argc, char **argv) {
    const char *path = argc > 1 ? argv[1] : "split_screen.png";
    bolan_context *context = NULL;
    game g = {.renderer = NULL};
    if (bolan_context_create(BOLAN_GL_CORE, &context) != BOLAN_OK) return 77; // no OpenGL on this machine
    bool ok = open_game(&g);
    if (ok) {
        bolan_world_settle(g.world, 30.0);
        draw(&g, 0, PLAYERS - 1, g.both);
        ok = bolan_png_write(path, WIDTH, HEIGHT, g.both) == BOLAN_OK;
        for (int i = 0; i < PLAYERS; ++i) {
            bolan_world_step(g.world, 31.0 + i); // another step, and back: a picture depends on its step and view alone
            bolan_world_settle(g.world, 30.0);
            draw(&g, i, i, g.alone);
            printf("player %d: %d bytes differ from the picture drawn alone\n", i, differences(&g, i));
            ok = ok && differences(&g, i) == 0;
        }
    }
    close_game(&g);
    bolan_context_destroy(&context);
    return ok ? 0 : 1;
}
