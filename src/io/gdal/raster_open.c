// SPDX-License-Identifier: MIT
// Opens a raster and chooses variable and band, unit and direction. The desc overrides the file; where neither decides,
// the file is refused with a list of its variables.
#include "io/file.h"
#include "io/gdal/raster.h"

#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { MOST_CANDIDATES = 64, LIST_MAX = 400 };

// A variable or band that may be the elevation.
typedef struct candidate {
    raster_words words;
    int number; // of the band, or of the sub-dataset
    int score;
} candidate;

// ---- what is written about a band -----------------------------------------------------------------------------------

static void copy_text(char *out, size_t size, const char *text) {
    snprintf(out, size, "%s", text ? text : "");
    for (char *c = out; *c; c++)
        if ((unsigned char)*c < 32 || *c == 127) *c = ' ';
}

static void read_words(GDALRasterBandH band, raster_words *w) {
    const char *variable = GDALGetMetadataItem(band, "NETCDF_VARNAME", NULL);
    copy_text(w->name, sizeof w->name, variable ? variable : GDALGetDescription(band));
    copy_text(w->standard, sizeof w->standard, GDALGetMetadataItem(band, "standard_name", NULL));
    copy_text(w->description, sizeof w->description, GDALGetMetadataItem(band, "long_name", NULL));
    copy_text(w->unit, sizeof w->unit, GDALGetRasterUnitType(band));
    if (!w->unit[0]) copy_text(w->unit, sizeof w->unit, GDALGetMetadataItem(band, "units", NULL));
    copy_text(w->positive, sizeof w->positive, GDALGetMetadataItem(band, "positive", NULL));
}

static bool is_color(GDALRasterBandH band) {
    const GDALColorInterp c = GDALGetRasterColorInterpretation(band);
    return c == GCI_RedBand || c == GCI_GreenBand || c == GCI_BlueBand || c == GCI_PaletteIndex;
}

static bool is_alpha(GDALRasterBandH band) { return GDALGetRasterColorInterpretation(band) == GCI_AlphaBand; }

// ---- choosing -------------------------------------------------------------------------------------------------------

static void list_candidates(const candidate *list, int count, char out[LIST_MAX]) {
    size_t used = 0;
    out[0] = '\0';
    for (int i = 0; i < count && used + 100 < LIST_MAX; i++) {
        const char *name = list[i].words.name;
        used += (size_t)snprintf(out + used, LIST_MAX - used, "%s%d%s%s", i ? ", " : "", list[i].number,
                                 name[0] ? " " : "", name);
        if (i + 1 < count && used + 100 >= LIST_MAX) snprintf(out + used, LIST_MAX - used, " ...");
    }
}

static bolan_result refuse_choice(const raster_source *s, const candidate *list, int count, const char *what) {
    char names[LIST_MAX];
    list_candidates(list, count, names);
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_RASTER_CHOICE, "%s: %s: %s", s->path, what, names);
    return BOLAN_ERROR_FORMAT;
}

// Index of the candidate with the wanted name, or of the single best one; -1 where there is none or several.
static int choose(const candidate *list, int count, const char *wanted) {
    int best = -1, equals = 0;
    for (int i = 0; i < count; i++) {
        const int score = wanted[0] ? (int)bolan_raster_same_text(list[i].words.name, wanted) : list[i].score;
        if (score == 0) continue;
        const int old = best < 0 ? 0 : wanted[0] ? 1 : list[best].score;
        if (score > old) best = i, equals = 0;
        equals += score >= old;
    }
    return equals == 1 ? best : -1;
}

// ---- the file -------------------------------------------------------------------------------------------------------

static GDALDatasetH open_quietly(raster_source *s, const char *name) {
    s->messages.count = 0; // drops the warnings of other variables
    return GDALOpenEx(name, GDAL_OF_RASTER | GDAL_OF_READONLY, NULL, NULL, NULL);
}

// The first bytes of a file, also of one in an archive; 0 where it cannot be opened.
static size_t read_head(const char *path, unsigned char head[4]) {
    VSILFILE *file = VSIFOpenL(path, "rb");
    if (!file) return 0;
    const size_t got = VSIFReadL(head, 1, 4, file);
    VSIFCloseL(file);
    return got;
}

static bolan_result cannot_open(const raster_source *s) {
    char message[RASTER_MESSAGE_MAX], file[BOLAN_PATH_MAX];
    size_t length;
    const char *part = bolan_file_of_raster(s->path, &length);
    snprintf(file, sizeof file, "%.*s", (int)length, part);
    unsigned char head[4] = {0};
    const size_t got = read_head(file, head);
    errno = 0;
    if (strncmp(file, "/vsi", 4) == 0 ? got == 0 : access(file, R_OK) != 0) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_OPEN, "%s: the raster cannot be read: %s", s->path,
                  strerror(errno ? errno : ENOENT));
        return BOLAN_ERROR_IO;
    }
    copy_text(message, sizeof message, CPLGetLastErrorMsg());
    const bool zip = got == sizeof head && memcmp(head, "PK\3\4", sizeof head) == 0;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_RASTER_OPEN, "%s: not a raster that GDAL reads: %s%s%s", s->path,
              zip          ? "it is a zip archive; name a raster in it, as in /vsizip/"
              : message[0] ? message
                           : "its content is of no format that is known",
              zip ? file : "", zip ? "/NAME" : "");
    return BOLAN_ERROR_FORMAT;
}

// The name of the variable of a sub-dataset: the text after the last colon or slash.
static const char *variable_of(const char *name) {
    const char *colon = strrchr(name, ':'), *start = colon ? colon + 1 : name, *slash = strrchr(start, '/');
    return slash ? slash + 1 : start;
}

static const char *subdataset_name(GDALDatasetH file, int number) {
    char key[40];
    snprintf(key, sizeof key, "SUBDATASET_%d_NAME", number);
    return CSLFetchNameValue(GDALGetMetadata(file, "SUBDATASETS"), key);
}

// Opens the elevation of a file that holds several rasters (netCDF, HDF).
static bolan_result open_variable(raster_source *s, GDALDatasetH outer) {
    candidate list[MOST_CANDIDATES];
    int count = 0;
    const char *name;
    while (count < MOST_CANDIDATES && (name = subdataset_name(outer, count + 1))) {
        candidate *c = &list[count++];
        *c = (candidate){.number = count};
        GDALDatasetH inner = open_quietly(s, name);
        if (inner && GDALGetRasterCount(inner) > 0) {
            read_words(GDALGetRasterBand(inner, 1), &c->words);
            copy_text(c->words.name, sizeof c->words.name, variable_of(name));
            c->score = bolan_raster_elevation_score(&c->words);
        }
        if (inner) GDALClose(inner);
    }
    if (count == 0) return cannot_open(s);
    const int found = choose(list, count, s->desc->variable);
    if (found < 0)
        return refuse_choice(s, list, count,
                             s->desc->variable[0]
                                 ? "it has no such variable; expected one of"
                                 : "it holds several rasters, and none of them alone is known to be the "
                                   "elevation; name one with variable");
    s->file = open_quietly(s, subdataset_name(outer, list[found].number));
    copy_text(s->variable, sizeof s->variable, list[found].words.name);
    return s->file && GDALGetRasterCount(s->file) > 0 ? BOLAN_OK : cannot_open(s);
}

static bolan_result choose_band(raster_source *s) {
    candidate list[MOST_CANDIDATES];
    int count = 0, colors = 0;
    const int bands = GDALGetRasterCount(s->file), wanted = (int)s->desc->band;
    if (wanted > bands) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_RASTER_CHOICE, "%s: it has no band %d; expected 1 to %d", s->path, wanted,
                  bands);
        return BOLAN_ERROR_FORMAT;
    }
    for (int i = 1; i <= bands && count < MOST_CANDIDATES; i++) {
        GDALRasterBandH band = GDALGetRasterBand(s->file, i);
        if (is_alpha(band) || (wanted && i != wanted)) continue;
        candidate *c = &list[count++];
        *c = (candidate){.number = i};
        read_words(band, &c->words);
        c->score = bolan_raster_elevation_score(&c->words);
        colors += is_color(band);
    }
    if (count == 0 || (colors > 0 && !wanted))
        return refuse_choice(s, list, count, "its bands are colours; expected elevations, or the number of a band");
    // The variable may have been chosen already, as one of several in the file.
    const char *variable = s->variable[0] ? "" : s->desc->variable;
    const int found = count == 1 && (!variable[0] || wanted) ? 0 : choose(list, count, variable);
    if (found < 0)
        return refuse_choice(s, list, count,
                             variable[0] ? "no band of it, or more than one, has the name that was asked for; it has"
                                         : "it has several bands, and none of them alone is known to be the elevation; "
                                           "choose with band");
    s->number = list[found].number;
    s->band = GDALGetRasterBand(s->file, s->number);
    if (!s->variable[0]) copy_text(s->variable, sizeof s->variable, list[found].words.name);
    return BOLAN_OK;
}

// ---- mask, unit and direction ---------------------------------------------------------------------------------------

static void find_mask(raster_source *s) {
    const int flags = GDALGetMaskFlags(s->band);
    if (!(flags & (GMF_ALL_VALID | GMF_NODATA))) s->mask = GDALGetMaskBand(s->band);
    for (int i = 1; i <= GDALGetRasterCount(s->file) && !s->mask; i++)
        if (is_alpha(GDALGetRasterBand(s->file, i))) s->mask = GDALGetRasterBand(s->file, i);
}

// Metres per unit of the vertical part of the CRS; below 0 where its axis points down; 0 where there is none.
static double vertical_unit(const raster_source *s, const char **name) {
    OGRSpatialReferenceH crs = GDALGetSpatialRef(s->file);
    if (!crs || !OSRGetAttrValue(crs, "VERT_CS", 0)) return 0.0;
    char *text = NULL;
    const double metres = OSRGetTargetLinearUnits(crs, "VERT_CS", &text);
    OGRAxisOrientation axis = OAO_Up;
    OSRGetAxis(crs, "VERT_CS", 0, &axis);
    *name = text;
    return axis == OAO_Down ? -metres : metres;
}

static void find_unit(raster_source *s) {
    raster_words words;
    read_words(s->band, &words);
    if (s->variable[0]) memcpy(words.name, s->variable, sizeof words.name);
    if (!isnan(s->desc->vertical_scale)) {
        s->metres = s->desc->vertical_scale;
        copy_text(s->unit, sizeof s->unit, "vertical_scale");
        return;
    }
    const char *vertical_name = "";
    const double vertical = vertical_unit(s, &vertical_name);
    copy_text(s->unit, sizeof s->unit, words.unit[0] ? words.unit : vertical != 0.0 ? vertical_name : "");
    s->metres = vertical != 0.0 ? fabs(vertical) : 1.0;
    if (words.unit[0] && !bolan_raster_unit(words.unit, &s->metres)) {
        s->metres = 1.0;
        bolan_log(BOLAN_LOG_WARNING, BOLAN_LOG_RASTER_UNIT,
                  "%s: its unit is \"%s\", which is no known unit of length; metres are assumed (vertical_scale says "
                  "otherwise)",
                  s->path, words.unit);
    }
    const raster_direction direction = bolan_raster_direction_of(&words);
    const bool stated = words.positive[0] || direction == RASTER_DOWN;
    if (direction == RASTER_DOWN || (!stated && vertical < 0.0)) s->metres = -s->metres;
    s->perhaps_down = direction == RASTER_PERHAPS_DOWN && !(vertical < 0.0);
}

bolan_result bolan_raster_open(raster_source *s) {
    CPLErrorReset();
    s->file = open_quietly(s, s->path);
    if (!s->file) return cannot_open(s);
    bolan_result result = BOLAN_OK;
    if (GDALGetRasterCount(s->file) == 0) {
        GDALDatasetH outer = s->file;
        s->file = NULL;
        result = open_variable(s, outer);
        GDALClose(outer);
    }
    if (!result) result = choose_band(s);
    if (result) return result;
    s->width = GDALGetRasterXSize(s->file);
    s->height = GDALGetRasterYSize(s->file);
    find_mask(s);
    find_unit(s);
    return BOLAN_OK;
}
