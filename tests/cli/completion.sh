# SPDX-License-Identifier: MIT
# The completions of bash, zsh and fish: each shell takes its file, each has every option that --help prints for a command
# and no other, and the shells complete command lines by them.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

for shell in bash zsh fish; do
    run info --completion $shell
    mv out bolan.$shell
    command -v $shell > /dev/null && have="${have:-} $shell" || echo "no $shell here"
done
refuse 2 '--completion is tcsh; expected bash, zsh, fish' info --completion tcsh
case ${have:-} in
*bash*) ;;
*) exit 77 ;;
esac
[ -z "${BOLAN_REQUIRE_DOCS:-}" ] || [ "$have" = ' bash zsh fish' ] || fail "only$have are here"
for shell in $have; do $shell -n bolan.$shell || fail "$shell refuses its completions"; done

# What bash offers for the words of a command line, a line each.
cat > offer << 'END'
. ./bolan.bash
COMP_WORDS=(bolan "$@") COMP_CWORD=$#
_bolan
printf '%s\n' "${COMPREPLY[@]}"
END
offer() {
    bash ./offer "$@" | sort | tr '\n' ' '
}
offers() {
    wanted=$1
    shift
    [ "$(offer "$@")" = "$wanted" ] || fail "bolan $*: offered $(offer "$@"), expected $wanted"
}
run --help
sed -n 's/^  bolan \([a-z]*\) .*/\1/p' out | grep -v '^bench$' > commands
offers "$({ cat commands; printf '%s\n' --help --version; } | sort | tr '\n' ' ')" ''
while read -r name; do
    "$BOLAN" "$name" --help | sed -n '/^options:/,/^SCENE/p' | grep -o '^ *\(-., \)\{0,1\}--[a-z-]*' |
        tr -d ',' | tr -s ' ' '\n' | grep . | sort > options
    offers "$(tr '\n' ' ' < options)" "$name" -
    for option in $(grep -e '^--' options); do
        grep -q -- "'\{0,1\}$option\(=\|\[\)" bolan.zsh || grep -q -- ",$option" bolan.zsh || fail "zsh lacks $option"
        grep -q -- "__fish_seen_subcommand_from [a-z ]*$name[a-z ]*'.* -l ${option#--} " bolan.fish ||
            fail "fish lacks $option of bolan $name"
    done
done < commands

touch a.yaml sea.png
mkdir d
offers 'island ' render isl
offers 'a.yaml ' render a.y
offers 'd ' measure d
offers 'fft ' render --waves ff
offers 'fft ' render --waves = ff
offers 'cosines exp-cosine fft textures ' render --waves =
offers 'foam fog ' view --effects fo
offers 'sea.png ' render island -o se
offers 'sea.png ' info se
offers ' ' render --wind ''
offers 'spectrum ' export spec
offers 'storm ' export spectrum st
offers ' ' frobnicate ''

# The shells themselves, at a terminal.
python3 "$BOLAN_SOURCE_DIR/tests/cli/type.py" "$PWD" $have || fail 'a shell at a terminal'
