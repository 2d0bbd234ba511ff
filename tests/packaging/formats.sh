# SPDX-License-Identifier: MIT
# bolan_io without GDAL, assimp, OpenEXR, zlib and netCDF-C: it builds without their headers, says in one sentence what
# is missing, and
# its installation asks for none of them.
set -eu
. "$BOLAN_SOURCE_DIR/tests/packaging/common"
cat > use_formats.c << 'END'
#include "bolan/io.h"
#include <stdio.h>
#include <string.h>
static int sentences;
static void count(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level;
    sentences += id == BOLAN_LOG_UNSUPPORTED && strstr(sentence, "a.file: this build ") != NULL;
}
int main(void) {
    const bolan_hooks hooks = {.log = count};
    bolan_set_hooks(&hooks);
    bolan_raster_desc raster = bolan_raster_desc_default();
    strcpy(raster.path, "a.file");
    bolan_ground *ground = (bolan_ground *)&raster;
    bolan_model *model = (bolan_model *)&raster;
    const float pixel = 1.0f;
    int refused = bolan_raster_load(&raster, &ground) == BOLAN_ERROR_UNSUPPORTED && ground == NULL;
    refused += bolan_model_load(&(bolan_model_desc){.path = "a.file"}, &model) == BOLAN_ERROR_UNSUPPORTED && model == NULL;
    bolan_measured_spectrum *spectrum = (bolan_measured_spectrum *)&raster;
    static const char *const packed[] = {"\x1f\x8b", "\x89HDF\r\n\x1a\n"};
    for (int i = 0; i < 2; i++) {
        FILE *file = fopen("a.file", "wb");
        if (!file || fputs(packed[i], file) < 0 || fclose(file) != 0) return 1;
        refused += bolan_spectrum_load("a.file", NULL, &spectrum) == BOLAN_ERROR_UNSUPPORTED && spectrum == NULL;
        remove("a.file");
    }
    refused += bolan_exr_write("a.file", 1, 1, &(bolan_exr_channel){"Y", &pixel}, 1) == BOLAN_ERROR_UNSUPPORTED;
    const bolan_io_features have = bolan_io_get_features();
    printf("bolan_io %d %d %d\n", refused, sentences, have.rasters || have.models || have.exr || have.gzip || have.netcdf4);
    return 0;
}
END

configure bare -DBOLAN_WITH_GDAL=OFF -DBOLAN_WITH_ASSIMP=OFF -DBOLAN_WITH_OPENEXR=OFF -DBOLAN_WITH_ZLIB=OFF \
    -DBOLAN_WITH_NETCDF=OFF -DBOLAN_RENDER=OFF -DBOLAN_BENCH=OFF -DBOLAN_EXAMPLES=OFF
build_and_install bare "$PWD/prefix"
! grep -qi 'gdal\|assimp\|openexr\|-lz\|netcdf' "$(find prefix -name bolan_io.pc)" || fail "$(cat "$(find prefix -name bolan_io.pc)")"
pc=$(dirname "$(find prefix -name bolan.pc)")
# shellcheck disable=SC2046 # words
${CC:-cc} use_formats.c -o use_formats $(PKG_CONFIG_PATH="$pc" pkg-config --cflags --libs bolan_io) ||
    fail 'pkg-config --cflags --libs bolan_io does not build a program'
[ "$(./use_formats)" = 'bolan_io 5 5 0' ] || fail "said: $(./use_formats)"
[ ! -e a.file ] || fail 'a file was written'
