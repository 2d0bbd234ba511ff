# SPDX-License-Identifier: MIT
"""type.py FOLDER SHELLS...: types words and tabs into each shell at a terminal, with the completion FOLDER/bolan.SHELL, and
checks which command line it runs."""
import os
import pty
import select
import shutil
import sys
import tempfile
import time

# what is typed, and the arguments that the program gets
LINES = (("bolan rend\tisl\t--qual\tult\t", "render island --quality ultra"),
         ("bolan measure --wind-f\t225 --techn\tnest\t", "measure --wind-from 225 --technique nested-grid"),
         ("bolan export spec\t sto\t", "export spectrum storm"))


def start(shell, folder, home):
    """The shell at a terminal, and what it is told first."""
    spy = 'bolan() { echo "GOT<$*>"; }\n'
    setup = {"bash": (["bash", "--norc", "--noprofile", "-i"], f"{spy}. {folder}/bolan.bash\n"),
             "zsh": (["zsh", "-f", "-i"], f"{spy}fpath=({home} $fpath); autoload -U compinit; compinit -u -D\n"),
             "fish": (["fish", "--no-config", "-i"],
                      f"function bolan; echo \"GOT<$argv>\"; end\nsource {folder}/bolan.fish\n")}
    arguments, first = setup[shell]
    child, terminal = pty.fork()
    if child == 0:
        environment = dict(os.environ, HOME=home, TERM="dumb", PS1="$ ", XDG_DATA_HOME=home, XDG_CONFIG_HOME=home)
        os.execvpe(arguments[0], arguments, environment)
    return child, terminal, first


def until(terminal, text, seconds):
    """What the terminal shows until text stands in it or nothing comes any more."""
    seen, end = "", time.monotonic() + seconds
    while text not in seen and time.monotonic() < end:
        if select.select([terminal], [], [], 0.1)[0]:
            try:
                seen += os.read(terminal, 65536).decode("utf-8", "replace")
            except OSError:
                break
    return seen


def try_shell(shell, folder, home):
    child, terminal, first = start(shell, folder, home)
    failures = []
    try:
        os.write(terminal, (first + "echo READY'<>'\n").encode())
        until(terminal, "READY<>", 20)
        for typed, wanted in LINES:
            os.write(terminal, f"{typed}\n".encode())
            seen = until(terminal, "GOT<", 20)
            seen += until(terminal, ">", 5) if ">" not in seen.split("GOT<")[-1] else ""
            # zsh writes --quality=ultra
            if f"GOT<{wanted}>" not in seen.replace(" >", ">").replace("=", " "):
                failures.append(f"{shell}: {typed!r} did not become {wanted!r}: {seen!r}")
    finally:
        os.close(terminal)
        os.waitpid(child, 0)
    return failures


def main():
    folder, shells = sys.argv[1], sys.argv[2:]
    with tempfile.TemporaryDirectory() as home:
        shutil.copy(f"{folder}/bolan.zsh", f"{home}/_bolan")
        failures = [failure for shell in shells for failure in try_shell(shell, folder, home)]
    print("\n".join(failures))
    return 1 if failures else 0


sys.exit(main())
