# SPDX-License-Identifier: MIT
# bolan info --json is JSON, with the keys that docs/command-line.md lists and no other.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

run info --json
python3 -m json.tool out > pretty || fail "not JSON: $(cat out)"
sed -n '/^## info$/,/^## bench/p' "$BOLAN_SOURCE_DIR/docs/command-line.md" | sed -n 's/^| \(`.*`\) |.*/\1/p' |
    grep -o '`[a-z0-9_.]*`' | tr -d '`' | sort > documented
[ "$(wc -l < documented)" -ge 10 ] || fail 'docs/command-line.md lists no keys'
cat > keys.py << 'END'
import json
import sys
said = json.load(open("out"))
keys = set(said)
for name in ("gl", "files"):
    if said[name] is not None:
        keys |= {f"{name}.{key}" for key in said[name]}
documented = set(open("documented").read().split())
if said["gl"] is None:
    documented = {key for key in documented if not key.startswith("gl.")}
if keys != documented:
    sys.exit(f"not documented: {sorted(keys - documented)}; not printed: {sorted(documented - keys)}")
assert said["scenes"] == list(said["sea_bytes"]) and "island" in said["scenes"], said["scenes"]
assert all(size > 1e6 for size in said["sea_bytes"].values()), said["sea_bytes"]
assert said["cpu"][0] == "scalar" and "ocean" in said["techniques"] and said["processors"] >= 1
assert all(value in (True, False) for value in said["files"].values())
END
python3 keys.py || fail 'the keys'
[ "$(python3 -c 'import json; print(json.load(open("out"))["version"])')" = "$("$BOLAN" --version | sed 's/^bolan //')" ] ||
    fail 'another version'
