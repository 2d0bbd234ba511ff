// SPDX-License-Identifier: MIT
// See completion.h. After the command, a word that begins with a dash is completed to the options that go with it, and
// any other to what the command takes: the choices in its usage, scenes, or files.
#include "completion.h"

#include "commands.h"
#include "describe.h"

#include <string.h>


// ---- what the tables say --------------------------------------------------------------------------------------------

// Commands that every installation has: bench is there only beside its program.
static const command *find_command(const command *c) {
    while (c->name && c->exists) c++;
    return c;
}

static bool takes_scene(const command *c) { return strstr(c->arguments, "SCENE") != NULL; }

static bool takes_file(const option_info *info) { return info->argument && strstr(info->argument, "FILE"); }

static bool goes_with(const option_info *info, const command *c) { return c->bit && (info->commands & c->bit); }

// The words that the value of an option is one of; NULL where there is no such list.
static const char *const *value_names(const option_info *info) {
    if (info->kind == OPTION_NAME) return info->names;
    if (info->kind != OPTION_PARAM) return NULL;
    const bolan_param row = option_param(info);
    return row.kind == BOLAN_PARAM_NAME || row.kind == BOLAN_PARAM_SET ? row.names : NULL;
}

static void print_names(FILE *file, const char *const *names) {
    for (int i = 0; names[i]; i++) fprintf(file, "%s%s", i ? " " : "", names[i]);
}

static void print_value_names(FILE *file, const option_info *info) {
    if (info->kind == OPTION_PARAM && option_param(info).kind == BOLAN_PARAM_SET) fputs("all none ", file);
    print_names(file, value_names(info));
}

static void print_scenes(FILE *file) {
    for (uint32_t i = 0; bolan_scene_builtin_name(i); i++)
        fprintf(file, "%s%s", i ? " " : "", bolan_scene_builtin_name(i));
}

// The choices of a command's first argument: words in small letters with bars between them.
static size_t find_choices(const command *c, const char **start) {
    *start = c->arguments + strspn(c->arguments, "[");
    return **start == '-' ? 0 : strspn(*start, "abcdefghijklmnopqrstuvwxyz-|");
}

static bool has_choices(const command *c) {
    const char *start;
    return find_choices(c, &start) > 0;
}

static void print_choices(FILE *file, const command *c) {
    const char *start;
    const size_t length = find_choices(c, &start);
    for (size_t i = 0; i < length; i++) fputc(start[i] == '|' ? ' ' : start[i], file);
}

// The text between single quotes, without backquotes. @p escaped characters get @p escape before them.
static void print_quoted(FILE *file, const char *text, const char *escaped, const char *quote) {
    for (const char *p = text; *p; p++) {
        if (*p == '`') continue;
        if (*p == '\'') {
            fputs(quote, file);
        } else {
            fprintf(file, strchr(escaped, *p) ? "\\%c" : "%c", *p);
        }
    }
}

// ---- bash -----------------------------------------------------------------------------------------------------------

// The options for which `wanted` holds, as the pattern of a case; false, and nothing printed, where there is none.
static bool print_pattern(FILE *file, bool (*wanted)(const option_info *)) {
    bool any = false;
    for (const option_info *i = option_table; i->name; i++) {
        if (!wanted(i)) continue;
        fprintf(file, "%s--%s", any ? " | " : "    ", i->name);
        if (i->letter) fprintf(file, " | -%c", i->letter);
        any = true;
    }
    return any;
}

static bool wants_text(const option_info *info) { return info->argument && !takes_file(info) && !value_names(info); }

static void bash_command(FILE *file, const command *c) {
    fprintf(file, "        %s)\n            if [[ $current == -* ]]; then\n                words='", c->name);
    for (const option_info *i = option_table; i->name; i++) {
        if (!goes_with(i, c)) continue;
        if (i->letter) fprintf(file, "-%c ", i->letter);
        fprintf(file, "--%s ", i->name);
    }
    fputs("'\n", file);
    if (has_choices(c)) {
        fputs("            elif ((COMP_CWORD == 2)); then\n                words='", file);
        print_choices(file, c);
        fputs("'\n", file);
    }
    if (takes_scene(c)) {
        fputs("            else\n                words='", file);
        print_scenes(file);
        fputs("' files=yaml\n", file);
    } else if (strstr(c->arguments, "FILE")) {
        fputs("            else\n                files=all\n", file);
    }
    fputs("            fi\n            ;;\n", file);
}

static void print_bash(FILE *file) {
    fputs("# Completion of bolan for bash; written by bolan info --completion bash.\n_bolan() {\n"
          "    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} words='' files=''\n"
          "    # bash splits --name=value at the equals sign.\n"
          "    if [[ $current == = ]]; then\n        current=''\n    elif [[ $before == = ]]; then\n"
          "        before=${COMP_WORDS[COMP_CWORD - 2]}\n    fi\n    ((COMP_CWORD > 1)) || before='' # of the command\n"
          "    case $before in\n",
          file);
    for (const option_info *i = option_table; i->name; i++) {
        if (!value_names(i)) continue;
        fprintf(file, "    --%s) words='", i->name);
        print_value_names(file, i);
        fputs("' ;;\n", file);
    }
    if (print_pattern(file, takes_file)) fputs(") files=all ;;\n", file);
    if (print_pattern(file, wants_text)) fputs(") ;;\n", file);
    fputs("    '') words='", file);
    for (const command *c = find_command(command_table); c->name; c = find_command(c + 1))
        fprintf(file, "%s ", c->name);
    fputs("--help --version' ;;\n    *)\n        case ${COMP_WORDS[1]} in\n", file);
    for (const command *c = find_command(command_table); c->name; c = find_command(c + 1)) bash_command(file, c);
    fputs("        esac\n        ;;\n    esac\n"
          "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\"\n"
          "        [[ $files != all ]] || compgen -f -- \"$current\"\n"
          "        [[ $files != yaml ]] || { compgen -f -X '!*.yaml' -- \"$current\"; compgen -d -- \"$current\"; })\n"
          "    [[ -z $files ]] || compopt -o filenames 2> /dev/null\n    return 0\n}\ncomplete -F _bolan bolan\n",
          file);
}

// ---- zsh ------------------------------------------------------------------------------------------------------------

static void zsh_option(FILE *file, const option_info *info) {
    const char *equals = info->argument ? "=" : "";
    fputs("            ", file);
    if (info->letter) {
        fprintf(file, "'(-%c --%s)'{-%c,--%s%s}'[", info->letter, info->name, info->letter, info->name, equals);
    } else {
        fprintf(file, "'--%s%s[", info->name, equals);
    }
    print_quoted(file, describe_option_help(info), "[]:\\", "'\\''");
    fputc(']', file);
    if (info->argument) {
        fputc(':', file);
        print_quoted(file, info->argument, "[]:\\", "'\\''");
        fputc(':', file);
    }
    if (value_names(info)) {
        fputc('(', file);
        print_value_names(file, info);
        fputc(')', file);
    } else if (takes_file(info)) {
        fputs("_files", file);
    } else if (info->argument) {
        fputc(' ', file);
    }
    fputs("' \\\n", file);
}

static void zsh_command(FILE *file, const command *c) {
    fprintf(file, "    %s)\n        _arguments -S \\\n", c->name);
    for (const option_info *i = option_table; i->name; i++)
        if (goes_with(i, c)) zsh_option(file, i);
    if (has_choices(c)) {
        fputs("            '1:what:(", file);
        print_choices(file, c);
        fputs(")' \\\n", file);
    }
    if (takes_scene(c)) {
        fputs("            '*:scene:_bolan_scenes'\n", file);
    } else {
        fprintf(file, "            '*:file:%s'\n", strstr(c->arguments, "FILE") ? "_files" : " ");
    }
    fputs("        ;;\n", file);
}

static void print_zsh(FILE *file) {
    fputs("#compdef bolan\n# Completion of bolan for zsh; written by bolan info --completion zsh.\n"
          "_bolan_scenes() {\n    local -a scenes\n    scenes=(",
          file);
    print_scenes(file);
    fputs(")\n    _alternative 'scenes:scene:($scenes)' 'files:scene file:_files -g \"*.yaml(-.)\"'\n}\n\n_bolan() {\n"
          "    local -a commands\n    commands=(\n",
          file);
    for (const command *c = find_command(command_table); c->name; c = find_command(c + 1)) {
        fprintf(file, "        '%s:", c->name);
        print_quoted(file, c->help, ":\\", "'\\''");
        fputs("'\n", file);
    }
    fputs("    )\n    if ((CURRENT == 2)); then\n        _describe command commands\n        return\n    fi\n"
          "    local command=$words[2]\n    shift words\n    ((CURRENT--))\n    case $command in\n",
          file);
    for (const command *c = find_command(command_table); c->name; c = find_command(c + 1)) zsh_command(file, c);
    fputs("    esac\n}\n\n_bolan \"$@\"\n", file);
}

// ---- fish -----------------------------------------------------------------------------------------------------------

static void fish_condition(FILE *file, const option_info *info) {
    fputs("complete -c bolan -n '__fish_seen_subcommand_from", file);
    for (const command *c = find_command(command_table); c->name; c = find_command(c + 1))
        if (goes_with(info, c)) fprintf(file, " %s", c->name);
    fputc('\'', file);
}

static void fish_option(FILE *file, const option_info *info) {
    fish_condition(file, info);
    if (info->letter) fprintf(file, " -s %c", info->letter);
    fprintf(file, " -l %s", info->name);
    if (value_names(info)) {
        fputs(" -x -a '", file);
        print_value_names(file, info);
        fputc('\'', file);
    } else if (info->argument) {
        fputs(takes_file(info) ? " -r -F" : " -x", file);
    }
    fputs(" -d '", file);
    print_quoted(file, describe_option_help(info), "\\", "\\'");
    fputs("'\n", file);
}

static void fish_command(FILE *file, const command *c) {
    fprintf(file, "complete -c bolan -n __fish_use_subcommand -f -a %s -d '", c->name);
    print_quoted(file, c->help, "\\", "\\'");
    fputs("'\n", file);
    if (!has_choices(c) && !takes_scene(c)) return;
    fprintf(file, "complete -c bolan -n '__fish_seen_subcommand_from %s' -a '", c->name);
    print_choices(file, c);
    if (has_choices(c)) fputc(' ', file);
    if (takes_scene(c)) print_scenes(file);
    fputs("'\n", file);
}

static void print_fish(FILE *file) {
    fputs("# Completion of bolan for fish; written by bolan info --completion fish.\n"
          "complete -c bolan -n __fish_use_subcommand -f -l help -d 'this text'\n"
          "complete -c bolan -n __fish_use_subcommand -f -l version -d 'the version'\n",
          file);
    for (const command *c = find_command(command_table); c->name; c = find_command(c + 1)) fish_command(file, c);
    for (const option_info *i = option_table; i->name; i++) fish_option(file, i);
}

void completion_print(FILE *file, int shell) {
    static void (*const printers[])(FILE *) = {print_bash, print_zsh, print_fish};
    printers[shell](file);
}
