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
