# SPDX-License-Identifier: MIT
# The Debian packages: they are built beside the source tree, which stays clean; lintian finds no error; their files serve C
# programs, Python and man. As root with BOLAN_TEST_INSTALL=1 they are installed and purged.
# The objects are those of packaging/shared; BOLAN_TEST_LONG=1 compiles as make deb does.
set -eu
. "$BOLAN_SOURCE_DIR/tests/packaging/common"
for tool in dh dh_python3 dpkg-buildpackage; do
    command -v $tool > /dev/null && continue
    [ -z "${BOLAN_REQUIRE_DEB:-}" ] || fail "$tool is missing"
    echo "skipped: $tool is missing; tools/setup.sh deb installs it"
    exit 77
done
write_programs
shared=$BOLAN_BUILD_DIR/tests/packaging/shared/shared
[ -z "${BOLAN_TEST_LONG:-}" ] && [ -e "$shared/build.ninja" ] || shared=$PWD/build
minor=$(version)
minor=${minor%.*}
# Files that git does not know, other than those of builds.
clean() {
    git -C "$BOLAN_SOURCE_DIR" status --porcelain --ignored 2> /dev/null |
        grep '^[?!]' | grep -v ' \(build\(-[a-z]*\)\{0,1\}\|out\)/$' || true
}
before=$(clean)
DEB_BUILD_OPTIONS="noautodbgsym parallel=${BOLAN_TEST_JOBS:-2}" "$BOLAN_SOURCE_DIR/tools/deb.sh" deb "$shared" > made ||
    fail "$(cat made)"
[ "$(clean)" = "$before" ] || fail "the source tree is not as it was: $(clean)"
packages="bolan libbolan$minor libbolan-dev python3-bolan"
for package in $packages; do
    file=$(ls deb/"$package"_*.deb) || fail "no package $package"
    [ "$(dpkg-deb -f "$file" Version)" = "$(version)" ] || fail "the version of $package"
    dpkg-deb -x "$file" root
done
dpkg-deb -f deb/bolan_*.deb Depends | grep -q "libbolan$minor (>= $(version))" || fail 'the program does not need the libraries'
dpkg-deb -f deb/python3-bolan_*.deb Depends | grep -q 'python3-numpy' || fail 'the Python module does not need numpy'
[ "$(dpkg-deb -f deb/libbolan-dev_*.deb Depends)" = "libbolan$minor (= $(version))" ] || fail 'libbolan-dev needs another'
if command -v lintian > /dev/null; then
    lintian --allow-root --profile debian --fail-on error deb/*.changes > lintian.log 2>&1 || fail "$(cat lintian.log)"
else
    [ -z "${BOLAN_REQUIRE_DEB:-}" ] || fail 'lintian is missing'
    echo 'no lintian here'
fi

# A folder in the place of /
lib=$(dirname "$(find root -name libbolan.so)")
[ "$(LD_LIBRARY_PATH=$PWD/$lib root/usr/bin/bolan --version)" = "bolan $(version)" ] || fail 'the program does not start'
! readelf -d "$lib"/libbolan_io.so root/usr/bin/bolan | grep 'RPATH\|RUNPATH' || fail 'a path of libraries is left'
gzip -cd root/usr/share/man/man1/bolan.1.gz | grep -q '^\.TH BOLAN' || fail 'no manual page'
for file in bash-completion/completions/bolan zsh/vendor-completions/_bolan fish/vendor_completions.d/bolan.fish; do
    [ -s root/usr/share/$file ] || fail "no $file"
done
load_path=$PWD/$lib # the loader knows it after an installation
use_pkg_config "$PWD/root/usr" bolan bolan_content bolan_io bolan_render
use_find_package "$PWD/root/usr" bolan bolan_content bolan_io bolan_render
python() {
    (cd / && "$@" /usr/bin/python3 -B -c 'import bolan; print(bolan.version(), bolan.Sea(bolan.SeaState.from_wind(9.0, 0.0, 1e5)).heights([[0.0, 0.0]]).shape)')
}
said=$(python env LD_LIBRARY_PATH="$PWD/$lib" PYTHONPATH="$PWD/root/usr/lib/python3/dist-packages") || fail 'import bolan'
[ "$said" = "$(version) (1,)" ] || fail "Python said $said"
no_paths root "$BOLAN_SOURCE_DIR" "$BOLAN_BUILD_DIR" "$PWD"

[ "$(id -u)" = 0 ] && [ -n "${BOLAN_TEST_INSTALL:-}" ] || exit 0
installed() { dpkg-query -W -f '${Package}\n' 'bolan*' 'libbolan*' 'python3-bolan*' 2> /dev/null || true; }
[ -z "$(installed)" ] || { echo "installed already, and left alone: $(installed)"; exit 0; }
apt() { DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300 --no-install-recommends "$@" > apt.log 2>&1; }
# shellcheck disable=SC2086,SC2064 # words; the names of now
trap "apt purge $packages" EXIT
apt install ./deb/*.deb || fail "$(cat apt.log)"
[ "$(bolan --version)" = "bolan $(version)" ] || fail 'the installed program does not start'
[ "$(python env -u PYTHONPATH)" = "$(version) (1,)" ] || fail 'import bolan after the installation'
${CC:-cc} "$BOLAN_SOURCE_DIR/examples/01_hello_sea.c" -o hello $(pkg-config --cflags --libs bolan) || fail 'no example'
./hello > hello.log || fail 'the example does not run'
# shellcheck disable=SC2086
dpkg -L $packages | sort -u > files
# shellcheck disable=SC2086
apt purge $packages || fail "$(cat apt.log)"
trap - EXIT
[ -z "$(installed)" ] || fail "still there: $(installed)"
while read -r file; do
    case $file in
    */bolan* | */libbolan* | */_bolan) [ ! -e "$file" ] || fail "$file is left after the purge" ;;
    esac
done < files
