# SPDX-License-Identifier: Apache-2.0
# pacer_embed(TARGET NAME file...): puts files into TARGET as they are. Each is reached through
#   #include "embedded/NAME.h"   ->   std::string_view pacer::embedded::NAME(std::string_view file)
# which throws std::out_of_range for a file name (without folder) that was not embedded.
enable_language(ASM)
function(pacer_embed target name)
  set(folder ${PROJECT_BINARY_DIR}/generated/embedded)
  set(assembly ".section .rodata\n")
  set(declarations "")
  set(table "")
  set(files "")
  set(count 0)
  foreach(file ${ARGN})
    get_filename_component(path ${file} ABSOLUTE)
    get_filename_component(base ${file} NAME)
    list(APPEND files ${path})
    set(symbol pacer_embedded_${name}_${count})
    string(APPEND assembly ".global ${symbol}\n${symbol}:\n.incbin \"${path}\"\n"
      ".global ${symbol}_end\n${symbol}_end:\n.byte 0\n")
    string(APPEND declarations "extern const char ${symbol}[];\nextern const char ${symbol}_end[];\n")
    string(APPEND table
      "  if (file == \"${base}\") return {${symbol}, static_cast<std::size_t>(${symbol}_end - ${symbol})};\n")
    math(EXPR count "${count} + 1")
  endforeach()
  string(APPEND assembly ".section .note.GNU-stack,\"\",%progbits\n")
  file(CONFIGURE OUTPUT ${folder}/${name}.S CONTENT "${assembly}" @ONLY)
  file(CONFIGURE OUTPUT ${folder}/${name}.h CONTENT "#pragma once

#include <string_view>

namespace pacer::embedded {
/// The embedded file of this name; throws std::out_of_range when there is none.
[[nodiscard]] std::string_view ${name}(std::string_view file);
}  // namespace pacer::embedded
" @ONLY)
  file(CONFIGURE OUTPUT ${folder}/${name}.cc CONTENT "#include \"embedded/${name}.h\"

#include <stdexcept>
#include <string>

extern \"C\" {
${declarations}}

namespace pacer::embedded {
std::string_view ${name}(std::string_view file) {
${table}  throw std::out_of_range(\"not embedded: \" + std::string(file));
}
}  // namespace pacer::embedded
" @ONLY)
  set_source_files_properties(${folder}/${name}.S PROPERTIES OBJECT_DEPENDS "${files}")
  target_sources(${target} PRIVATE ${folder}/${name}.S ${folder}/${name}.cc)
endfunction()
