// SPDX-License-Identifier: MIT
// What the page sets, by the keys of scene files: "sea.wind.speed", "water.type", "camera.position" and so on.
// Three keys stand for the one swell of the page: sea.swell.hs, sea.swell.tp, sea.swell.from.
#ifndef WEB_SETTINGS_H
#define WEB_SETTINGS_H

#include "bolan/scene.h"

// Puts the value of @p key into the scene, as text in the unit of the key. False: there is no such key, or the text is
// no value of it; the log says what was expected, and the scene stays as it was.
bool settings_set(bolan_scene *scene, const char *key, const char *text);
// Writes the value of @p key; "" where there is no such key.
void settings_get(const bolan_scene *scene, const char *key, char *out, size_t capacity);
// Writes the row of @p key as JSON: label, unit, help, low, high, digits, logarithmic, names. "null": no such key.
void settings_describe(const char *key, char *out, size_t capacity);

#endif
