# SPDX-License-Identifier: MIT
# cmake -DNAME= -DHEADER= -DFOLDER= -DFILES=a|b -DOUTPUT= -P embed_text.cmake: text files -> one C table (BolanEmbed.cmake).

string(REPLACE "|" ";" files "${FILES}")
set(entries "")
set(count 0)
foreach(file IN LISTS files)
    file(READ ${FOLDER}/${file} text)
    string(REPLACE "\\" "\\\\" text "${text}")
    string(REPLACE "\"" "\\\"" text "${text}")
    string(REPLACE "?" "\\?" text "${text}") # no trigraphs
    string(REPLACE "\n" "\\n\"\n     \"" text "${text}")
    string(APPEND entries "    {\"${file}\",\n     \"${text}\"},\n")
    math(EXPR count "${count} + 1")
endforeach()
string(APPEND entries "    {0, 0},\n") # a table is never empty
file(WRITE ${OUTPUT}.new "// Generated from ${count} text files by cmake/embed_text.cmake.
#include \"${HEADER}\"

const ${NAME} ${NAME}s[] = {
${entries}};
const unsigned ${NAME}_count = ${count};
")
file(RENAME ${OUTPUT}.new ${OUTPUT})
