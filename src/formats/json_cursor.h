// SPDX-License-Identifier: MIT
/// @file json_cursor.h
/// Walking through JSON (RFC 8259) by a cursor: members of an object, elements of an array, and what stands in them.
/// Nothing is stored, so that a file of many records costs one pass a value. Brackets are counted, commas are not
/// checked. Private to src/formats.
#ifndef BOLAN_FORMATS_JSON_CURSOR_H
#define BOLAN_FORMATS_JSON_CURSOR_H

#include "formats/text.h"

/// The value of a key of the object that begins at @p object; false where there is none, or it is no object.
bool bolan_json_cursor_member(text_cursor object, const char *key, text_cursor *value);
/// The first element of the array that begins at @p array; false where it is empty or no array.
bool bolan_json_cursor_first(text_cursor array, text_cursor *element);
/// The element after @p element; false at the end.
bool bolan_json_cursor_after(text_cursor *element);
/// The characters of a string, or a number or literal, that begins here; false for an object or array.
bool bolan_json_cursor_scalar(text_cursor value, text_word *word);

#endif
