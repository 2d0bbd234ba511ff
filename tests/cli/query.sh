# SPDX-License-Identifier: MIT
# bolan query: rows in the order of the points, the statistics of the sea they are taken from, refusals.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

printf 'x,y\n0,0\n10.5,-3\n# a comment\n1e4 2e4\n' > points.csv
run query open-sea --points points.csv
[ "$(head -1 out)" = 'x,y,height,normal_x,normal_y,normal_z,jacobian,residual' ] || fail 'another header'
[ "$(wc -l < out)" -eq 4 ] || fail 'not a row a point'
[ "$(cut -d, -f1,2 out | tail -3 | tr '\n' ' ')" = '0,0 10.5,-3 10000,20000 ' ] || fail 'another order'
awk -F, 'NR > 1 { n = sqrt($4 * $4 + $5 * $5 + $6 * $6); if (n < 0.99999 || n > 1.00001 || $6 <= 0) exit 1 }' out ||
    fail 'a normal is no unit vector upwards'
awk -F, 'NR > 1 && $7 > 0.2 && $8 >= 1e-3 { exit 1 }' out || fail 'a residual is a millimetre or more'
cp out first.csv
run query open-sea --points points.csv --threads 1 -o second.csv
cmp first.csv second.csv || fail '-o differs from stdout, or threads changed the sea'
"$BOLAN" query open-sea --points - < points.csv | cmp - first.csv || fail 'standard input differs from the file'
run query open-sea --points points.csv --time 21
! cmp -s out first.csv || fail 'the sea stands still'

# 4 standard deviations of the heights over many points are the sea's hs: within 5 % by chance for a net of 60 x 60
# points, and up to 7 % below it, since the fields are interpolated linearly between samples, which shaves waves of few
# samples.
awk 'BEGIN { for (i = 0; i < 60; i++) for (j = 0; j < 60; j++) print i * 101 "," j * 97 }' > net.csv
run query open-sea --points net.csv
spread=$(awk -F, 'NR > 1 { s += $3; q += $3 * $3; n++ } END { print 4 * sqrt(q / n - (s / n) ^ 2) }' out)
run measure open-sea --json
near "$spread" "$(value hs)" "$(awk -v h="$(value hs)" 'BEGIN { print h * 0.12 }')"

# The normal is that of the heights around, each column by itself: of 300 points, the squares of the difference are less
# than half of the squares of the slope (a quarter and a third: the slope over half a metre lacks the waves shorter than
# that). Columns that change places, or a sign, give 2 and more. The Jacobian is 1 on average.
awk 'BEGIN { d = 0.25; for (i = 0; i < 300; i++) { x = i * 37.3; y = i * 11.7 - 900
    print x "," y; print x + d "," y; print x - d "," y; print x "," y + d; print x "," y - d } }' > cross.csv
run query open-sea --points cross.csv
awk -F, 'NR > 1 {
    k = (NR - 2) % 5; h[k] = $3
    if (k == 0) { nx = $4 / $6; ny = $5 / $6; j += $7; n++ }
    if (k == 4) { sx = (h[1] - h[2]) / 0.5; sy = (h[3] - h[4]) / 0.5
        ex += (nx + sx) ^ 2; ey += (ny + sy) ^ 2; qx += sx ^ 2; qy += sy ^ 2 }
} END { exit !(n == 300 && ex < 0.5 * qx && ey < 0.5 * qy && j / n > 0.9 && j / n < 1.1) }' out ||
    fail 'the normals are not those of the heights'

# On the land of the island the water has no waves: its height is the water level.
printf '0,0\n' > land.csv
run query island --points land.csv
near "$(tail -1 out | cut -d, -f3)" 0 1e-6

# Columns in the order asked for. Points with a z are in the water there, without one at the surface, where dynamic and
# hydrostatic pressure add up to 0; in the air all is 0.
printf 'x,y,z\n0,0,-5\n0,0,40\n0,0\n' > deep.csv
run query open-sea --points deep.csv
motion=velocity_x,velocity_y,velocity_z,acceleration_x,acceleration_y,acceleration_z
[ "$(head -1 out)" = "x,y,z,height,$motion,pressure,wet" ] ||
    fail 'z is not answered'
run query open-sea --points deep.csv --columns z,height,velocity_x,pressure,wet,rise,foam
[ "$(head -1 out)" = 'z,height,velocity_x,pressure,wet,rise,foam' ] || fail 'another header than the columns'
[ "$(sed -n 3p out | cut -d, -f3-5)" = '0,0,0' ] || fail 'there is water in the air'
[ "$(sed -n 4p out | cut -d, -f1)" = '' ] || fail 'a point without z has one'
near "$(sed -n 4p out | cut -d, -f4)" "$(sed -n 4p out | awk -F, '{ print 1026 * 9.81 * $2 }')" 300 # two reconstructions
awk -F, 'NR == 2 && ($3 == 0 || $4 == 0 || $5 != 1) { exit 1 }' out || fail 'the water does not move'
run query open-sea --points deep.csv --columns velocity
[ "$(head -1 out)" = 'velocity_x,velocity_y,velocity_z' ] || fail 'a vector is not its components'
run query open-sea --points deep.csv --columns velocity_x,pressure --stretching wheeler
mv out wheeler
run query open-sea --points deep.csv --columns velocity_x,pressure
! cmp -s out wheeler || fail 'stretching changes nothing'
run query open-sea --points net.csv --columns height --least-wavelength 1000
long=$(awk -F, 'NR > 1 { q += $1 * $1 } END { print q }' out)
run query open-sea --points net.csv --columns height --least-wavelength 1
awk -v a="$long" 'NR > 1 { q += $1 * $1 } END { exit !(a < 0.1 * q) }' out || fail 'a least wavelength of 1 km leaves the waves'
refuse 2 '--columns has hight; expected x, y, z, height' query --points deep.csv --columns x,hight
refuse 2 '--columns has an empty name' query --points deep.csv --columns x,,y
refuse 2 '--columns is empty' query --points deep.csv --columns ''
refuse 2 '--least-wavelength is -1; expected a number from 0' query --points deep.csv --least-wavelength -1
refuse 2 '--stretching is long; expected none, wheeler' query --points deep.csv --stretching long

# A file of many batches: a row a point, in their order, the same as in pieces, in constant memory.
awk 'BEGIN { for (i = 0; i < 50000; i++) print i * 0.37 - 5000 "," (i % 977) * 3.1 }' > many.csv
run query open-sea --points many.csv -o many-answers.csv
[ "$(wc -l < many-answers.csv)" -eq 50001 ] || fail 'not a row a point of many'
tail -5000 many.csv > end.csv
run query open-sea --points end.csv
tail -5000 out > end
tail -5000 many-answers.csv | cmp - end || fail 'a point is answered otherwise in a long file'
(
    awk 'BEGIN { for (i = 0; i < 400000; i++) print i "," i }' > long.csv
    ulimit -v 400000
    "$BOLAN" query pond --points long.csv --threads 1 > long-out || fail 'a long file takes more memory'
    [ "$(wc -l < long-out)" -eq 400001 ] || fail 'not a row a point of a long file'
)
rm -f long.csv long-out
# A bad line far down: named, and no file is left.
sed 's/^\(-4999.*\)$/\1/; 49999s/.*/7,oops/' many.csv > late.csv
refuse 1 'late.csv:49999: found oops; expected y' query open-sea --points late.csv -o late-out.csv
awk 'BEGIN { for (i = 0; i < 70000; i++) printf "1"; print "" }' > wide.csv
refuse 1 'wide.csv:1: found a line of more than 65535 bytes' query open-sea --points wide.csv

printf '1,2\n3,abc\n' > bad.csv
refuse 1 'bad.csv:2: found abc; expected y, a number of metres' query --points bad.csv -o out.csv
printf '1,nan\n' > nan.csv
refuse 1 'nan.csv:1: found nan; expected y' query --points nan.csv -o out.csv
: > empty.csv
refuse 1 'empty.csv: there is no point in it' query --points empty.csv
refuse 1 'none.csv: cannot be read' query --points none.csv
refuse 1 'no/such/out.csv: cannot be written: No such file or directory' query --points points.csv -o no/such/out.csv
status=0
"$BOLAN" query open-sea --points points.csv > /dev/full 2> err || status=$?
[ "$status" -eq 1 ] || fail "a full disk behind stdout: exit code $status"
