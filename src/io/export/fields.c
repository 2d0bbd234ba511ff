// SPDX-License-Identifier: MIT
// Fields of the waves: planes of the cascades, or of the surface over a grid of the world; as parts of an EXR, or as
// variables of NetCDF, a record a frame.
#include "io/export/netcdf.h"

#include "bolan/export.h"
#include "bolan/query.h"

#include <string.h>

enum { FIELDS = 9, MOST_SETS = BOLAN_MAX_CASCADES, FIELD_HEIGHT = 0 };

// A field of CF: a standard name where there is one.
typedef struct field_info {
    const char *name, *standard, *meaning, *unit;
} field_info;

static const field_info cascade_fields[FIELDS] = {
    {"height", NULL, "height of the waves of this cascade over rest points", "m"},
    {"dx", NULL, "displacement of parcels to the east, choppiness not applied", "m"},
    {"dy", NULL, "displacement of parcels to the north, choppiness not applied", "m"},
    {"slope_x", NULL, "gradient of the height to the east", "1"},
    {"slope_y", NULL, "gradient of the height to the north", "1"},
    {"dxx", NULL, "gradient of dx to the east", "1"},
    {"dyy", NULL, "gradient of dy to the north", "1"},
    {"dxy", NULL, "gradient of dx to the north", "1"},
    {"foam", NULL, "foam memory", "1"},
};
static const field_info grid_fields[FIELDS] = {
    {"height", "sea_surface_height_above_mean_sea_level", "height of the surface", "m"},
    {"normal_x", NULL, "unit normal of the surface, east", "1"},
    {"normal_y", NULL, "unit normal of the surface, north", "1"},
    {"normal_z", NULL, "unit normal of the surface, up", "1"},
    {"jacobian", NULL, "Jacobian of the horizontal displacement", "1"},
    {"velocity_x", "sea_water_x_velocity", "velocity of the water at the surface, east", "m s-1"},
    {"velocity_y", "sea_water_y_velocity", "velocity of the water at the surface, north", "m s-1"},
    {"velocity_z", "upward_sea_water_velocity", "velocity of the water at the surface, up", "m s-1"},
    {"foam", NULL, "foam memory of the parcel at this place", "1"},
};

// The planes of a cascade, or of the grid.
typedef struct field_set {
    uint32_t columns, rows;
    double x0, y0, step; // of the coordinates [m]
    bolan_cascade_view layout;
    float *plane[FIELDS]; // one block of memory
    size_t bytes;
} field_set;

typedef struct fields {
    bolan_world *world;
    const bolan_export_fields_desc *desc;
    const char *path;
    const field_info *info;
    bolan_water water;
    bolan_flow *flow;
    uint32_t sets;
    field_set set[MOST_SETS];
    bolan_dvec2 *row; // of the grid
    bolan_query_point *points;
    bolan_surface_motion *motion;
} fields;

static bolan_result refuse(const char *path, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT, "%s: %s", path, what);
    return BOLAN_ERROR_ARGUMENT;
}

// ---- planes ---------------------------------------------------------------------------------------------------------

// What a spline of coefficients is at its samples: the mean of 3 x 3 with weights (1, 4, 1) / 6 each way.
static void spline_at(const bolan_cascade_view *v, uint32_t i, uint32_t j, float out[3]) {
    static const double weight[3] = {1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0};
    double sum[3] = {0.0, 0.0, 0.0};
    for (uint32_t b = 0; b < 3; b++)
        for (uint32_t a = 0; a < 3; a++) {
            const uint32_t row = (j + v->n + b - 1) % v->n, column = (i + v->n + a - 1) % v->n;
            const bolan_sea_texel *t = &v->displacement[(size_t)row * v->pitch + column];
            const double w = weight[a] * weight[b];
            sum[0] += w * (double)t->height, sum[1] += w * (double)t->dx, sum[2] += w * (double)t->dy;
        }
    for (int k = 0; k < 3; k++) out[k] = (float)sum[k];
}

static void make_cascade(fields *f, uint32_t index) {
    field_set *s = &f->set[index];
    const bolan_cascade_view v = bolan_sea_cascade(f->water.sea, index);
    s->layout = v;
    for (uint32_t j = 0; j < v.n; j++)
        for (uint32_t i = 0; i < v.n; i++) {
            const size_t at = (size_t)j * v.n + i;
            float spline[3];
            spline_at(&v, i, j, spline);
            const float values[FIELDS] = {
                spline[0],     spline[1], spline[2], v.slope_x[at],
                v.slope_y[at], v.dxx[at], v.dyy[at], v.displacement[(size_t)j * v.pitch + i].dxy,
                v.foam[at]};
            for (int k = 0; k < FIELDS; k++) s->plane[k][at] = values[k];
        }
}

static void make_row(fields *f, uint32_t row) {
    const field_set *s = &f->set[0];
    const size_t first = (size_t)row * s->columns;
    for (uint32_t i = 0; i < s->columns; i++) f->row[i] = (bolan_dvec2){s->x0 + i * s->step, s->y0 + row * s->step};
    bolan_query_surface(&f->water, f->row, s->columns, f->points);
    bolan_query_motion(&f->water, NULL, f->row, s->columns, f->motion);
    bolan_query_foam(&f->water, f->row, s->columns, s->plane[FIELDS - 1] + first);
    for (uint32_t i = 0; i < s->columns; i++) {
        const bolan_query_point *p = &f->points[i];
        const bolan_vec3 v = f->motion[i].velocity;
        const float values[FIELDS - 1] = {p->height, p->normal.x, p->normal.y, p->normal.z, p->jacobian, v.x, v.y, v.z};
        for (int k = 0; k < FIELDS - 1; k++) s->plane[k][first + i] = values[k];
    }
}

// The planes of a frame.
static void make_frame(fields *f, double start, uint32_t frame) {
    const bolan_export_frames *frames = &f->desc->frames;
    const double time = start + frame / frames->fps;
    if (frames->count > 1 && frame == 0) bolan_world_settle(f->world, time);
    if (frame > 0) bolan_world_step(f->world, time);
    if (f->flow) bolan_flow_step(f->flow, f->water.sea);
    for (uint32_t i = 0; i < f->sets && !f->desc->resampled; i++) make_cascade(f, i);
    for (uint32_t row = 0; f->desc->resampled && row < f->set[0].rows; row++) make_row(f, row);
    if (frames->progress) frames->progress(frames->user, (uint32_t)((frame + 1) * 1000ull / frames->count), 1000);
}

// ---- life -----------------------------------------------------------------------------------------------------------

static bool allocate_set(field_set *s) {
    const size_t plane = (size_t)s->columns * s->rows;
    s->bytes = FIELDS * plane * sizeof(float);
    s->plane[0] = bolan_allocate(s->bytes);
    for (int k = 1; k < FIELDS && s->plane[0]; k++) s->plane[k] = s->plane[0] + k * plane;
    return s->plane[0] != NULL;
}

static bolan_result open_cascades(fields *f) {
    f->info = cascade_fields;
    f->sets = bolan_sea_cascade_count(f->water.sea);
    if (f->sets == 0)
        return refuse(f->path,
                      "this sea is a sum of waves and has no cascades; expected a grid of the world (resampled)");
    for (uint32_t i = 0; i < f->sets; i++) {
        field_set *s = &f->set[i];
        s->layout = bolan_sea_cascade_layout(f->water.sea, i);
        s->columns = s->rows = s->layout.n;
        s->step = s->layout.length / s->layout.n;
        if (!allocate_set(s)) return BOLAN_ERROR_MEMORY;
    }
    return BOLAN_OK;
}

static bolan_result open_grid(fields *f) {
    field_set *s = &f->set[0];
    f->info = grid_fields;
    f->sets = 1;
    bolan_export_grid_size(&f->desc->grid, &s->columns, &s->rows);
    if (s->columns == 0)
        return refuse(f->path,
                      "the rectangle or its spacing is out of range; expected corners within 1e7 m, south-west "
                      "first, and 2 to 65536 points along a side, at most 2^28 in all");
    s->x0 = f->desc->grid.from.x, s->y0 = f->desc->grid.from.y, s->step = f->desc->grid.spacing;
    f->row = bolan_allocate(s->columns * sizeof *f->row);
    f->points = bolan_allocate(s->columns * sizeof *f->points);
    f->motion = bolan_allocate(s->columns * sizeof *f->motion);
    if (!f->row || !f->points || !f->motion || !allocate_set(s)) return BOLAN_ERROR_MEMORY;
    const bolan_result result = bolan_flow_create(f->water.sea, &f->flow);
    f->water.flow = f->flow;
    return result;
}

static void close_fields(fields *f) {
    const uint32_t columns = f->set[0].columns;
    bolan_flow_destroy(&f->flow);
    bolan_release(f->row, columns * sizeof *f->row);
    bolan_release(f->points, columns * sizeof *f->points);
    bolan_release(f->motion, columns * sizeof *f->motion);
    for (uint32_t i = 0; i < f->sets; i++) bolan_release(f->set[i].plane[0], f->set[i].bytes);
}

// ---- EXR ------------------------------------------------------------------------------------------------------------

// Rows of an image run down, those of a field up.
static void turn_over(const field_set *s) {
    for (int k = 0; k < FIELDS; k++)
        for (uint32_t j = 0; j < s->rows / 2; j++)
            for (uint32_t i = 0; i < s->columns; i++) {
                float *low = &s->plane[k][(size_t)j * s->columns + i];
                float *high = &s->plane[k][(size_t)(s->rows - 1 - j) * s->columns + i];
                const float kept = *low;
                *low = *high, *high = kept;
            }
}

static bolan_result write_exr(fields *f) {
    enum { ATTRIBUTES = 9 };
    static const char *const names[MOST_SETS] = {"cascade0", "cascade1", "cascade2", "cascade3"};
    bolan_exr_part parts[MOST_SETS];
    bolan_exr_channel channels[MOST_SETS][FIELDS];
    bolan_exr_attribute attributes[MOST_SETS][ATTRIBUTES];
    const double time = bolan_sea_time(f->water.sea);
    make_frame(f, time, 0);
    for (uint32_t i = 0; i < f->sets; i++) {
        const field_set *s = &f->set[i];
        const bolan_cascade_view *v = &s->layout;
        turn_over(s);
        for (int k = 0; k < FIELDS; k++) channels[i][k] = (bolan_exr_channel){f->info[k].name, s->plane[k]};
        const bolan_exr_attribute of_grid[] = {{"time", NULL, 1, {time}},
                                               {"spacing", NULL, 1, {s->step}},
                                               {"west", NULL, 1, {s->x0}},
                                               {"south", NULL, 1, {s->y0}}};
        const bolan_exr_attribute of_cascade[ATTRIBUTES] = {{"time", NULL, 1, {time}},
                                                            {"spacing", NULL, 1, {s->step}},
                                                            {"length", NULL, 1, {v->length}},
                                                            {"angle", NULL, 1, {v->angle}},
                                                            {"k_min", NULL, 1, {v->k_min}},
                                                            {"k_max", NULL, 1, {v->k_max}},
                                                            {"variance", NULL, 1, {v->variance}},
                                                            {"origin_x", NULL, 1, {v->origin_x}},
                                                            {"origin_y", NULL, 1, {v->origin_y}}};
        const uint32_t count = f->desc->resampled ? 4 : ATTRIBUTES;
        memcpy(attributes[i], f->desc->resampled ? of_grid : of_cascade, count * sizeof *of_grid);
        parts[i] = (bolan_exr_part){.name = f->desc->resampled ? NULL : names[i],
                                    .width = s->columns,
                                    .height = s->rows,
                                    .channels = channels[i],
                                    .channel_count = FIELDS,
                                    .attributes = attributes[i],
                                    .attribute_count = count,
                                    .half = f->desc->half};
    }
    return bolan_exr_write_parts(f->path, parts, f->sets);
}

// ---- NetCDF ---------------------------------------------------------------------------------------------------------

static nc_variable *add_variable(nc_file *nc, bool is_double, int a, int b, int c) {
    nc_variable *v = &nc->variable[nc->variables++];
    *v = (nc_variable){.dimension = {a, b, c}, .is_double = is_double};
    return v;
}

static void add_coordinate(nc_file *nc, const field_set *s, bool resampled, uint32_t index, bool along) {
    const int d = (int)nc->dimensions++;
    char *name = nc->dimension[d];
    if (resampled) {
        bolan_format(name, sizeof nc->dimension[d], "%s", along ? "x" : "y");
    } else {
        bolan_format(name, sizeof nc->dimension[d], "%s_%u", along ? "u" : "v", (unsigned)index);
    }
    nc->length[d] = along ? s->columns : s->rows;
    nc_variable *v = add_variable(nc, true, d, -1, -1);
    memcpy(v->name, name, sizeof nc->dimension[d]);
    if (resampled)
        bolan_nc_describe(v, "standard_name", along ? "projection_x_coordinate" : "projection_y_coordinate", 0.0);
    bolan_nc_describe(v, "long_name",
                      resampled
                          ? (along ? "distance east of the world's origin" : "distance north of the world's origin")
                          : (along ? "distance along the tile" : "distance across the tile"),
                      0.0);
    bolan_nc_describe(v, "units", "m", 0.0);
    if (resampled) bolan_nc_describe(v, "axis", along ? "X" : "Y", 0.0);
}

static void add_layout(nc_variable *v, const bolan_cascade_view *layout) {
    bolan_nc_describe(v, "tile_length", NULL, layout->length);
    bolan_nc_describe(v, "tile_angle", NULL, layout->angle);
    bolan_nc_describe(v, "k_min", NULL, layout->k_min);
    bolan_nc_describe(v, "k_max", NULL, layout->k_max);
    bolan_nc_describe(v, "variance", NULL, layout->variance);
}

// The records of a set: its fields, and of a cascade where its tile lies.
static void add_fields(const fields *f, uint32_t index, nc_file *nc) {
    const bool resampled = f->desc->resampled;
    const int x = (int)nc->dimensions - 1, y = x - 1;
    for (int k = 0; k < FIELDS; k++) {
        const field_info *info = &f->info[k];
        nc_variable *v = add_variable(nc, false, NC_TIME, y, x);
        if (resampled) {
            bolan_format(v->name, sizeof v->name, "%s", info->name);
        } else {
            bolan_format(v->name, sizeof v->name, "%s_%u", info->name, (unsigned)index);
        }
        if (info->standard) bolan_nc_describe(v, "standard_name", info->standard, 0.0);
        bolan_nc_describe(v, "long_name", info->meaning, 0.0);
        bolan_nc_describe(v, "units", info->unit, 0.0);
        if (!resampled && k == FIELD_HEIGHT) add_layout(v, &f->set[index].layout);
    }
    for (int k = 0; k < 2 && !resampled; k++) {
        nc_variable *v = add_variable(nc, true, NC_TIME, -1, -1);
        bolan_format(v->name, sizeof v->name, "origin_%s_%u", k ? "y" : "x", (unsigned)index);
        bolan_nc_describe(v, "long_name", "where sample (0, 0) of the tile lies", 0.0);
        bolan_nc_describe(v, "units", "m", 0.0);
    }
}

static void describe(const fields *f, nc_file *nc) {
    static const char source[] = "Bolan";
    nc->attribute[nc->attributes++] = (nc_attribute){"Conventions", "CF-1.8", 0.0};
    nc->attribute[nc->attributes++] = (nc_attribute){"title", bolan_world_scene(f->world)->name, 0.0};
    nc->attribute[nc->attributes++] = (nc_attribute){"source", source, 0.0};
    nc->attribute[nc->attributes++] = (nc_attribute){"bolan_version", bolan_version(), 0.0};
    bolan_format(nc->dimension[NC_TIME], sizeof nc->dimension[NC_TIME], "time");
    nc->length[NC_TIME] = f->desc->frames.count;
    nc->dimensions = 1;
    for (uint32_t i = 0; i < f->sets; i++) {
        add_coordinate(nc, &f->set[i], f->desc->resampled, i, false);
        add_coordinate(nc, &f->set[i], f->desc->resampled, i, true);
        if (i == 0) {
            nc_variable *time = add_variable(nc, true, NC_TIME, -1, -1);
            bolan_format(time->name, sizeof time->name, "time");
            bolan_nc_describe(time, "standard_name", "time", 0.0);
            bolan_nc_describe(time, "units", "seconds since 1970-01-01 00:00:00", 0.0);
            bolan_nc_describe(time, "calendar", "standard", 0.0);
            bolan_nc_describe(time, "axis", "T", 0.0);
            bolan_nc_describe(time, "comment", "time of the scene; the date of its zero is nominal", 0.0);
        }
        add_fields(f, i, nc);
    }
}

static void write_coordinates(const fields *f, export_writer *w) {
    for (uint32_t i = 0; i < f->sets; i++) {
        const field_set *s = &f->set[i];
        for (uint32_t k = 0; k < s->rows; k++) bolan_export_f64(w, s->y0 + k * s->step);
        for (uint32_t k = 0; k < s->columns; k++) bolan_export_f64(w, s->x0 + k * s->step);
    }
}

// In the order of the variables.
static void write_record(const fields *f, double time, export_writer *w) {
    bolan_export_f64(w, time);
    for (uint32_t i = 0; i < f->sets; i++) {
        const field_set *s = &f->set[i];
        for (size_t k = 0; k < FIELDS * (size_t)s->columns * s->rows && !w->result; k++)
            bolan_export_f32(w, s->plane[0][k]);
        if (f->desc->resampled) continue;
        bolan_export_f64(w, s->layout.origin_x);
        bolan_export_f64(w, s->layout.origin_y);
    }
}

static bolan_result write_nc(fields *f) {
    export_writer w;
    nc_file nc = {.variable = bolan_allocate(NC_MOST_VARIABLES * sizeof *nc.variable)};
    if (!nc.variable) return BOLAN_ERROR_MEMORY;
    describe(f, &nc);
    const bolan_result opened = bolan_export_open(f->path, &w);
    if (!opened) {
        const double start = bolan_sea_time(f->water.sea);
        bolan_nc_write_header(&nc, &w);
        write_coordinates(f, &w);
        for (uint32_t frame = 0; frame < f->desc->frames.count && !w.result; frame++) {
            make_frame(f, start, frame);
            write_record(f, bolan_sea_time(f->water.sea), &w);
        }
    }
    bolan_release(nc.variable, NC_MOST_VARIABLES * sizeof *nc.variable);
    return opened ? opened : bolan_export_close(&w, true);
}

// ---- either ---------------------------------------------------------------------------------------------------------

bolan_result bolan_export_fields(bolan_world *world, const bolan_export_fields_desc *desc, const char *path) {
    BOLAN_ASSERT(world && desc && path);
    const bool exr = bolan_export_has_suffix(path, ".exr");
    const bolan_export_frames *frames = &desc->frames;
    if (!exr && !bolan_export_has_suffix(path, ".nc")) return refuse(path, "expected a name that ends in .exr or .nc");
    if (frames->count < 1 || frames->count > 100000 || !(frames->fps >= 1e-3 && frames->fps <= 1e3))
        return refuse(path, "the frames are out of range; expected 1 to 100000 of them, 0.001 to 1000 a second");
    if (exr && frames->count > 1) return refuse(path, "several frames in one .exr; expected a .nc, or a file each");
    fields f = {.world = world, .desc = desc, .path = path, .water = *bolan_world_water(world)};
    bolan_result result = desc->resampled ? open_grid(&f) : open_cascades(&f);
    if (!result) result = exr ? write_exr(&f) : write_nc(&f);
    if (result == BOLAN_ERROR_MEMORY)
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for the fields", path);
    close_fields(&f);
    return result;
}
