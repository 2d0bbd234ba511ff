# SPDX-License-Identifier: MIT
# tools/setup.sh, with an apt-get that only writes down how it was called: no call when nothing is missing, one install of
# what is, and a list where there is no apt-get.
set -eu
. "$BOLAN_SOURCE_DIR/tests/packaging/common"
unset BOLAN_SKIP_SETUP
setup="$BOLAN_SOURCE_DIR/tools/setup.sh"
mkdir bin
cat > bin/apt-get << END
#!/bin/sh
echo "\$*" >> "$PWD/calls"
END
cat > bin/sudo << 'END'
#!/bin/sh
exec "$@"
END
# Every package but $LACKS is installed.
cat > bin/dpkg-query << 'END'
#!/bin/sh
shift 3
for package; do [ "$package" = "${LACKS:-}" ] || echo "ii $package"; done
END
chmod +x bin/*
run() { (PATH=$PWD/bin:$PATH && "$setup" "$@") > out 2>&1; }

for groups in '' build test docs deb 'build deb'; do
    # shellcheck disable=SC2086 # words
    run $groups || fail "setup.sh $groups: $(cat out)"
    [ ! -s out ] && [ ! -e calls ] || fail "setup.sh $groups: $(cat out calls)"
done
export LACKS=cmake
run build || fail "setup.sh without cmake: $(cat out)"
[ "$(cat calls)" = "update -q
install -q -y --no-install-recommends cmake" ] || fail "called: $(cat calls)"
rm calls
# What only the tests, the site or the packages need is not installed for a build.
for LACKS in libcmocka-dev doxygen lintian; do
    run build || fail "$(cat out)"
    [ ! -e calls ] || fail "the build installs $LACKS"
done
status=0
run farm || status=$?
[ $status = 2 ] && grep -q 'unknown group farm; expected build, test, docs, deb' out || fail "a group too many: $(cat out)"

# Elsewhere: silent where the build has what it needs, else a list.
mkdir elsewhere
for tool in sh sort tr; do ln -s "$(command -v $tool)" elsewhere/$tool; done
status=0
(PATH=$PWD/elsewhere && "$setup" build) > out 2>&1 || status=$?
[ $status = 1 ] && grep -q 'libyaml-dev' out || fail "without apt-get: $(cat out)"
for tool in cc cmake ninja pkg-config; do printf '#!/bin/sh\nexit 0\n' > elsewhere/$tool; done
chmod +x elsewhere/*
(PATH=$PWD/elsewhere && "$setup" build) > out 2>&1 || fail "a build on another system: $(cat out)"
[ ! -s out ] || fail "a build on another system: $(cat out)"
