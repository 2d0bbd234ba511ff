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
    /// A double.
    BOLAN_PARAM_NUMBER,
    /// A uint32_t or uint64_t, by the size of the field.
    BOLAN_PARAM_WHOLE,
    /// A bool.
    BOLAN_PARAM_FLAG,
    /// An enum: names[0] stands for the value `low`, the last name for `high`.
    BOLAN_PARAM_NAME,
    /// A uint32_t: bit i stands for names[i].
    BOLAN_PARAM_SET,
    /// A char[size], NUL included.
    BOLAN_PARAM_TEXT,
} bolan_param_kind;

/// Rules of a row, as bits.
typedef enum bolan_param_rule {
    /// 0 is valid beside the range and means "not given"; `otherwise` says what is used then.
    BOLAN_PARAM_OR_ZERO = 1 << 0,
    /// NAN is valid beside the range and means "not given"; `otherwise` says what is used then.
    BOLAN_PARAM_OR_NAN = 1 << 1,
    /// The range holds for the magnitude; the field may have either sign.
    BOLAN_PARAM_EITHER_SIGN = 1 << 2,
    /// A WHOLE that is a power of two.
    BOLAN_PARAM_POWER_OF_TWO = 1 << 3,
    /// A slider for the field is logarithmic.
    BOLAN_PARAM_LOGARITHMIC = 1 << 4,
    /// A TEXT that names a file; relative to the scene file.
    BOLAN_PARAM_PATH = 1 << 5,
    /// A scene file must give the key.
    BOLAN_PARAM_REQUIRED = 1 << 6,
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
    /// What the parameter is, in one sentence without a full stop.
    const char *help;
    /// What is used where the parameter is not given and the default does not say, such as "the whole raster".
    /// NULL: the default.
    const char *otherwise;
    /// Names of NAME and SET, NULL at the end; for TEXT the names that documentation lists, or NULL.
    const char *const *names;
    /// The type of the field.
    bolan_param_kind kind;
    /// Bits of bolan_param_rule.
    unsigned rules;
    /// Where the field lies in the struct, and its size [bytes].
    size_t offset, size;
    /// The range of the field, ends included.
    double low, high;
    /// The default; a TEXT has always "".
    double fallback;
    /// Units of the field in one unit of the key and the option: 1000 where a key in km sets a field in m.
    /// 0: key and option have the unit of the field.
    double factor;
    /// The unit of the key and the option where `factor` is set, such as "km".
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
    /// The rows.
    const bolan_param *params;
    /// Number of rows.
    uint32_t count;
} bolan_param_table;

/// A table at a place in a larger struct, under a map of a scene file.
typedef struct bolan_param_group {
    /// The member of the larger struct, such as "terrain.island"; "" for the struct itself.
    const char *field;
    /// For a list, or a map without keys: what it is, for documentation. NULL: none.
    const char *help;
    /// The map of a scene file, dotted; "" for the document itself.
    const char *key;
    /// Where the member lies in the larger struct [bytes]; for a list, where its first element lies.
    size_t offset;
    /// The parameters of the member, or of one element of a list.
    const bolan_param_table *table;
    /// Most elements of a list; 0 where the member is no list.
    uint32_t capacity;
    /// Distance of two elements of a list, and where the uint32_t with their number lies [bytes].
    size_t stride, count_offset;
} bolan_param_group;

/// Returns the row of the field @p field; NULL when there is none.
BOLAN_API const bolan_param *bolan_param_find(const bolan_param_table *table, const char *field);
/// Returns the value of the field as a number.
/// A FLAG gives 0 or 1, a NAME or SET its stored number, a TEXT its length.
BOLAN_API double bolan_param_get(const bolan_param *param, const void *desc);
/// Writes a number to the field, without a check of its range.
/// A TEXT stays as it is.
BOLAN_API void bolan_param_set(const bolan_param *param, void *desc, double value);
/// Returns whether @p value, in the unit of the field, lies in the range and obeys the rules.
BOLAN_API bool bolan_param_accepts(const bolan_param *param, double value);
/// Reads @p size bytes of @p text, the value of a key or an option, into the field.
/// Numbers are in units of the key.
/// Names may have any case.
/// A SET is a list of names, separated by commas or blanks, or "all" or "none".
/// Returns false where the text is no such value or outside the range; then nothing is changed or logged.
BOLAN_API bool bolan_param_parse(const bolan_param *param, const char *text, size_t size, void *desc);
/// Describes the values that bolan_param_parse() accepts, for messages: "a number from 0 to 70 m/s".
/// The text is cut to @p capacity bytes.
BOLAN_API void bolan_param_expected(const bolan_param *param, char *out, size_t capacity);
/// Returns the first row with the dotted key @p path, such as "sky.clouds.cover" or, in a list, "objects.scale".
/// Returns NULL when there is none.
/// @param count receives the number of rows that share the key.
/// @param group receives the group of the rows; may be NULL.
BOLAN_API const bolan_param *bolan_param_find_key(const bolan_param_group *groups, const char *path,
                                                  const bolan_param_group **group, uint32_t *count);
/// Appends the keys of the map @p map, "" for the document, to the text @p words, each once and separated by ", ".
/// The text is cut to @p capacity bytes.
BOLAN_API void bolan_param_list_keys(const bolan_param_group *groups, const char *map, char *words, size_t capacity);
/// Sets the fields of the table to their defaults; other fields stay as they are.
BOLAN_API void bolan_params_default(const bolan_param_table *table, void *desc);
/// Checks every field of the table.
/// At the first wrong field it logs one sentence and returns ARGUMENT.
/// The sentence begins with @p where and names the field, the value and what was expected.
BOLAN_API bolan_result bolan_params_validate(const bolan_param_table *table, const void *desc, const char *where);

#ifdef __cplusplus
}
#endif
#endif
