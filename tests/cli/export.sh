# SPDX-License-Identifier: MIT
# bolan export mesh, fields and sky: each format, sequences, what is refused; memory, full disks and interrupts.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

area='--rect 0,0,60,40 --spacing 2'
# shellcheck disable=SC2086 # split on purpose
{
    run export mesh open-sea -o a.ply $area
    head -c 300 a.ply | grep -aq 'element vertex 651' || fail 'a.ply has another number of vertices'
    run export mesh open-sea -o a.glb $area --frames 3 --fps 10
    [ "$(head -c 4 a.glb)" = glTF ] || fail 'a.glb is no glTF'
    run export mesh open-sea -o 's%%-%02d.ply' $area --frames 2
    [ "$(ls s*)" = "$(printf 's%%-00.ply\ns%%-01.ply')" ] || fail "a sequence: $(ls s*)"
    cmp a.ply s%-00.ply || fail 'the first of a sequence is another mesh'
    if cmp -s s%-00.ply s%-01.ply; then fail 'the second of a sequence is the first'; fi
    run export mesh island -o g.ply $area --with ground
    head -c 600 g.ply | grep -aq 'element vertex 1302' || fail 'g.ply has no ground'
    "$BOLAN" export mesh open-sea -o a.obj $area 2> err
    grep -q 'warning: a.obj: OBJ has no place for the velocity' err || fail "a.obj said: $(cat err)"
    [ "$(grep -c '^vn ' a.obj)" -eq 651 ] || fail 'a.obj has another number of vertices'
    run export mesh open-sea -o view.ply --size 320x180 --camera 0,0,10,90,-5

    # Equal to what query says: the grid of a NetCDF is at fixed points.
    run export fields open-sea -o g.nc $area --frames 2
    [ "$(head -c 3 g.nc)" = CDF ] || fail 'g.nc is no NetCDF'
    run export fields open-sea -o c.nc
    if "$BOLAN" info --json | grep -q '"exr": true'; then
        run export fields open-sea -o g.exr $area --half
        run export fields open-sea -o c.exr
    fi
    rm -f out err

    # Results do not depend on the threads.
    run export mesh open-sea -o one.ply $area --threads 1
    cmp a.ply one.ply || fail 'a mesh depends on the threads'
    rm -f out err

    refuse 2 'bolan export cake: expected mesh, fields, sky or spectrum' export cake -o a.ply
    refuse 2 'bolan export needs to know what' export -o b.ply
    refuse 2 'bolan export mesh needs -o FILE' export mesh
    refuse 2 'expected a name that ends in .ply, .obj or .glb' export mesh -o b.stl
    refuse 2 'expected a name that ends in .exr or .nc' export fields -o b.png
    refuse 2 'expected a name that ends in .exr' export sky -o b.hdr
    refuse 2 'twice as wide as high' export sky -o b.exr --size 100x100
    refuse 2 'into one file; expected a .glb' export mesh -o b.ply --frames 2
    refuse 2 'into one file; expected a .nc' export fields -o b.exr --frames 2
    refuse 2 'south-west corner first' export mesh -o b.ply --rect 10,0,0,10
    refuse 2 'the scene has no ground' export mesh open-sea -o b.ply $area --with ground
    refuse 2 '--with cake: expected ground' export mesh -o b.ply --with cake
    refuse 2 '--half goes with an .exr' export fields -o b.nc --half
    refuse 2 '--half does not go with bolan export mesh' export mesh -o b.ply --half
    refuse 1 'no/a.ply: cannot be written' export mesh -o no/a.ply

    # Files that may not grow, and full disks.
    (
        ulimit -f 8
        for name in big.ply big.glb; do
            refuse 1 "$name: cannot be written: File too large" export mesh open-sea -o $name $area
        done
        refuse 1 'big.nc: cannot be written: File too large' export fields open-sea -o big.nc $area
    )
    if [ -e /dev/full ]; then
        ln -s /dev/full full.ply
        refuse 1 'full.ply: cannot be written: No space left on device' export mesh open-sea -o full.ply $area
        rm full.ply
    fi
}

# Memory does not grow with the file: 1025 x 1025 vertices are 97 MB; BOLAN_EXPORT_LONG=1: 4097 x 4097, 1.5 GB.
points=1024
[ -z "${BOLAN_EXPORT_LONG:-}" ] || points=4096
if [ -x /usr/bin/time ]; then
    /usr/bin/time -f '%M' -o peak "$BOLAN" export mesh open-sea -o big.ply --rect 0,0,$points,$points --spacing 1
    size=$(($(stat -c %s big.ply) / 1024))
    peak=$(tail -n 1 peak)
    echo "a mesh of $((points + 1)) x $((points + 1)): $size KiB in a peak of $peak KiB"
    [ "$peak" -lt $((size * 3 / 2 + 100000)) ] || fail "memory: $peak KiB for a file of $size KiB"
    rm -f big.ply peak
fi

# Interrupts leave nothing.
mkdir work
cd work
for kind in 'mesh open-sea -o m.ply' 'mesh open-sea -o m.glb' 'fields open-sea -o m.nc'; do
    # shellcheck disable=SC2086
    "$BOLAN" export $kind --rect 0,0,4000,4000 --spacing 1 > ../out 2> ../err < /dev/null &
    process=$!
    tries=0
    until grep -q '^SigCgt:.*[67]$' "/proc/$process/status" && ls m.*part* > /dev/null 2>&1; do
        tries=$((tries + 1))
        [ "$tries" -lt 600 ] || fail "export $kind: never began its file"
        kill -0 "$process" 2> /dev/null || fail "export $kind: ended by itself: $(cat ../err)"
        sleep 0.05
    done
    kill -TERM "$process"
    status=0
    wait "$process" || status=$?
    [ "$status" -eq 130 ] || fail "export $kind after TERM: exit code $status"
    [ -z "$(ls -A)" ] || fail "export $kind after TERM: left $(ls -A)"
done
cd ..

need_gl
run export sky open-sea -o sky.exr --size 128x64 --quality low --sun 130,30
[ -s sky.exr ] || fail 'no sky'
