// SPDX-License-Identifier: MIT
/// @file params.h
/// Tier 0. Parameters as data: one row for each field of a desc that a person sets.
///
/// A row states name, type, unit, range, default and one sentence of help. The rows are the source of:
/// - validation and default values;
/// - the keys of scene files and the options of the command line;
/// - the rows of the viewer's panel;
/// - the tables of the documentation and the JSON schema for editors.
///
/// The tables stand beside their descs: bolan_sea_params in waves.h, bolan_scene_groups() in scene.h, and so on.
/// Every function here is pure and thread-safe.
#ifndef BOLAN_PARAMS_H
#define BOLAN_PARAMS_H

#include "bolan/base.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/// The type of a field.
typedef enum bolan_param_kind {
    BOLAN_PARAM_NUMBER, ///< double
    BOLAN_PARAM_WHOLE,  ///< uint32_t or uint64_t, by the size of the field
    BOLAN_PARAM_FLAG,   ///< bool
    BOLAN_PARAM_NAME,   ///< an enum: names[0] stands for the value `low`, the last name for `high`
    BOLAN_PARAM_SET,    ///< uint32_t: bit i stands for names[i]
    BOLAN_PARAM_TEXT,   ///< char[size], with its NUL
} bolan_param_kind;

/// What is special about a row, as bits.
typedef enum bolan_param_rule {
    BOLAN_PARAM_OR_ZERO = 1 << 0,      ///< 0 is valid beside the range: not given. `otherwise` says what stands in
    BOLAN_PARAM_OR_NAN = 1 << 1,       ///< NAN is valid beside the range: not given. `otherwise` says what stands in
    BOLAN_PARAM_EITHER_SIGN = 1 << 2,  ///< the range is that of the magnitude
    BOLAN_PARAM_POWER_OF_TWO = 1 << 3, ///< a WHOLE that is a power of two
    BOLAN_PARAM_LOGARITHMIC = 1 << 4,  ///< a slider over it is logarithmic
    BOLAN_PARAM_PATH = 1 << 5,         ///< a TEXT that names a file; relative to the scene file
    BOLAN_PARAM_REQUIRED = 1 << 6,     ///< a scene file has to give it
} bolan_param_rule;

/// One parameter.
typedef struct bolan_param {
    /// The member of the struct, such as "cosines.frequencies".
    const char *field;
    /// The key in scene files, dotted where maps are nested, such as "clouds.cover". NULL: scene files do not have it.
    /// Neighbouring rows with one key are the components of one list of numbers, such as a position.
    const char *key;
    /// The long option of the command line without its dashes. NULL: no option.
    const char *option;
    /// The unit of the field, such as "m/s". NULL: none.
    const char *unit;
    /// What it is, in one sentence without a full stop.
    const char *help;
    /// What stands in where it is not given and the default does not say, such as "the whole raster". NULL: the
    /// default.
    const char *otherwise;
    /// Names of NAME and SET, NULL at the end; of a TEXT names that documentation lists, or NULL.
    const char *const *names;
    bolan_param_kind kind;
    /// Bits of bolan_param_rule.
    unsigned rules;
    /// Where the field lies in the struct, and its size [bytes].
    size_t offset, size;
    /// The range of the field, ends included.
    double low, high;
    /// The default; of a TEXT always "".
    double fallback;
    /// A key or option counts in units of `factor` of the field's unit: 1000 and "km" for kilometres. 0: in the field's
    /// unit.
    double factor;
    const char *factor_unit;
    /// The label in a panel. NULL: the last part of the field's name.
    const char *label;
    /// The range of a slider, in units of the key; 0 and 0: the whole range.
    double usual_low, usual_high;
    /// Digits behind the point that a slider shows.
    int digits;
} bolan_param;

/// The parameters of one struct.
typedef struct bolan_param_table {
    /// The struct, "bolan_sea_desc".
    const char *type;
    const bolan_param *params;
    uint32_t count;
} bolan_param_table;

/// A table at a place in a larger struct, under a map of a scene file.
typedef struct bolan_param_group {
    /// The member of the larger struct, such as "terrain.island"; "" for the struct itself.
    const char *field;
    /// Of a list or of a map without keys: what it is, for documentation. NULL: none.
    const char *help;
    /// The map of a scene file, dotted; "" for the document itself.
    const char *key;
    /// Where the member lies: of a list, the member of its first element.
    size_t offset;
    const bolan_param_table *table;
    /// Of a list: the most elements, the distance of two [bytes], and where the uint32_t with their number lies. Else
    /// 0.
    uint32_t capacity;
    size_t stride, count_offset;
} bolan_param_group;

/// The row of the field @p field; NULL when there is none.
BOLAN_API const bolan_param *bolan_param_find(const bolan_param_table *table, const char *field);
/// The value as a number: of a FLAG 0 or 1, of a NAME or SET the number behind the name, of a TEXT its length.
BOLAN_API double bolan_param_get(const bolan_param *param, const void *desc);
/// Writes a number to the field; of a TEXT nothing. The range is not checked.
BOLAN_API void bolan_param_set(const bolan_param *param, void *desc, double value);
/// Whether @p value, in the field's unit, lies in the range and obeys the rules.
BOLAN_API bool bolan_param_accepts(const bolan_param *param, double value);
/// Reads @p size bytes of @p text, as a key or option has them, into the field: in units of the key; names in any case;
/// a SET as names with commas or blanks between, or "all" or "none". False, and nothing changed or logged, if the text
/// is no such value or outside the range.
BOLAN_API bool bolan_param_parse(const bolan_param *param, const char *text, size_t size, void *desc);
/// What bolan_param_parse() takes, for messages: "a number from 0 to 70 m/s". Cut to @p capacity bytes.
BOLAN_API void bolan_param_expected(const bolan_param *param, char *out, size_t capacity);
/// The first row with the dotted key @p path ("sky.clouds.cover"; in a list "objects.scale"), NULL when there is none.
/// @p count receives how many rows share the key; @p group, unless it is NULL, receives where they stand.
BOLAN_API const bolan_param *bolan_param_find_key(const bolan_param_group *groups, const char *path,
                                                  const bolan_param_group **group, uint32_t *count);
/// Adds the keys of the map @p map, "" for the document, to the text @p words, ", " between them and each once. Cut to
/// @p capacity bytes.
BOLAN_API void bolan_param_list_keys(const bolan_param_group *groups, const char *map, char *words, size_t capacity);
/// Fills the fields of the table with their defaults, and leaves the others.
BOLAN_API void bolan_params_default(const bolan_param_table *table, void *desc);
/// Checks every field of the table. At the first that is wrong it logs one sentence that begins with @p where, the
/// field, the value and what was expected, and returns ARGUMENT.
BOLAN_API bolan_result bolan_params_validate(const bolan_param_table *table, const void *desc, const char *where);

#ifdef __cplusplus
}
#endif
#endif
