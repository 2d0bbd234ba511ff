// SPDX-License-Identifier: MIT
// The named scenes and shipped spectra, embedded by cmake/embed_text.cmake. Paths are relative to scenes/
// ("island.yaml", "spectra/synthetic-bimodal.spec"), sorted.
#ifndef BOLAN_IO_SCENE_SOURCE_H
#define BOLAN_IO_SCENE_SOURCE_H

typedef struct bolan_scene_source {
    const char *path;
    const char *text;
} bolan_scene_source;

extern const bolan_scene_source bolan_scene_sources[];
extern const unsigned bolan_scene_source_count;

#endif
