// SPDX-License-Identifier: MIT
// Units, and the words that identify an elevation among other variables. Standard names are those of the CF conventions
// (cfconventions.org, version 1.11); the short names are the usual ones of GEBCO, ETOPO, ROMS and CMEMS files.
#include "io/gdal/raster.h"

#include <stdio.h>
#include <string.h>

// ---- text -----------------------------------------------------------------------------------------------------------

static char lower(char c) { return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c; }

bool bolan_raster_same_text(const char *a, const char *b) {
    while (*a && lower(*a) == lower(*b)) a++, b++;
    return lower(*a) == lower(*b);
}

// In lower case, with blanks for _ and -, and without blanks at the ends.
static void normalise(const char *text, char *out, size_t size) {
    size_t n = 0;
    while (*text == ' ') text++;
    for (; *text && n + 1 < size; text++) out[n++] = *text == '_' || *text == '-' ? ' ' : lower(*text);
    while (n > 0 && out[n - 1] == ' ') n--;
    out[n] = '\0';
}

static bool is_one_of(const char *text, const char *const *list) {
    for (; *list; list++)
        if (strcmp(text, *list) == 0) return true;
    return false;
}

static bool has_one_of(const char *text, const char *const *list) {
    for (; *list; list++)
        if (strstr(text, *list)) return true;
    return false;
}

// ---- units ----------------------------------------------------------------------------------------------------------

bool bolan_raster_unit(const char *unit, double *metres) {
    static const struct {
        const char *names[9];
        double metres;
    } units[] = {
        {{"m", "metre", "metres", "meter", "meters", "mts", NULL}, 1.0},
        {{"dm", "decimetre", "decimetres", "decimeter", "decimeters", NULL}, 0.1},
        {{"cm", "centimetre", "centimetres", "centimeter", "centimeters", NULL}, 0.01},
        {{"mm", "millimetre", "millimetres", "millimeter", "millimeters", NULL}, 0.001},
        {{"km", "kilometre", "kilometres", "kilometer", "kilometers", NULL}, 1000.0},
        {{"ft", "foot", "feet", "international foot", "international feet", "foot (international)", "ift", NULL},
         0.3048},
        {{"us survey foot", "us survey feet", "us ft", "ftus", "foot us", "survey foot", "sft", "us foot", NULL},
         1200.0 / 3937.0},
        {{"fathom", "fathoms", "fm", "ftm", NULL}, 1.8288},
        {{"yd", "yard", "yards", NULL}, 0.9144},
        {{"in", "inch", "inches", NULL}, 0.0254},
    };
    char text[48];
    normalise(unit, text, sizeof text);
    for (int whole = 1; whole >= 0; whole--) {
        for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
            if (!is_one_of(text, units[i].names)) continue;
            *metres = units[i].metres;
            return true;
        }
        text[strcspn(text, " (,;")] = '\0'; // "metres above sea level"
    }
    return false;
}

// ---- elevations -----------------------------------------------------------------------------------------------------

static bool is_depth_name(const char *standard) { return strncmp(standard, "sea floor depth", 15) == 0; }

static const char *const standard_heights[] = {"height above mean sea level",
                                               "height above geopotential datum",
                                               "height above reference ellipsoid",
                                               "surface altitude",
                                               "ground level altitude",
                                               "bedrock altitude",
                                               "altitude",
                                               NULL};
static const char *const short_names[] = {"z",          "elevation", "elev",   "height",     "altitude",  "topo",
                                          "topography", "bathy",     "depth",  "bathymetry", "topobathy", "deptho",
                                          "h",          "dem",       "relief", "rose",       "bedrock",   "bed",
                                          "dtm",        "dsm",       NULL};
static const char *const parts_of_names[] = {"elev",    "altitude", "bathym", "topograph",
                                             "terrain", "depth",    "relief", NULL};
static const char *const parts_of_others[] = {"uncertain", "error", "flag",   "mask",  "quality",
                                              "std",       "dev",   "count",  "tid",   "source",
                                              "density",   "slope", "aspect", "shade", NULL};

int bolan_raster_elevation_score(const raster_words *words) {
    char name[64], standard[64], description[128];
    double metres;
    normalise(words->name, name, sizeof name);
    normalise(words->standard, standard, sizeof standard);
    normalise(words->description, description, sizeof description);
    const bool length = bolan_raster_unit(words->unit, &metres);
    if (has_one_of(name, parts_of_others) || has_one_of(standard, parts_of_others)) return 0;
    if (words->unit[0] && !length) return 0;
    if (is_depth_name(standard) || is_one_of(standard, standard_heights)) return 5;
    if (standard[0] && strcmp(standard, "depth") != 0) return 0; // known to be something else
    if (is_one_of(name, short_names)) return 4;
    if (has_one_of(name, parts_of_names)) return 3;
    if (has_one_of(description, parts_of_others)) return 0;
    return has_one_of(description, parts_of_names) ? 2 : length ? 1 : 0;
}

raster_direction bolan_raster_direction_of(const raster_words *words) {
    char name[64], standard[64], description[128];
    normalise(words->name, name, sizeof name);
    normalise(words->standard, standard, sizeof standard);
    normalise(words->description, description, sizeof description);
    if (bolan_raster_same_text(words->positive, "down")) return RASTER_DOWN;
    if (bolan_raster_same_text(words->positive, "up")) return RASTER_UP;
    if (is_depth_name(standard) || strcmp(standard, "depth") == 0) return RASTER_DOWN;
    if (standard[0]) return RASTER_UP;
    // ROMS: h is the bathymetry at its points, positive down.
    if (strcmp(name, "h") == 0 && (strstr(description, "bathymetry") || strstr(description, "depth")))
        return RASTER_DOWN;
    const bool depth = strstr(name, "depth") || strstr(name, "bathy") || strcmp(name, "h") == 0;
    return depth ? RASTER_PERHAPS_DOWN : RASTER_UP;
}
