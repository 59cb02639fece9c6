#pragma once

#include <string_view>

namespace rob::runtime {

/// Results for standard output, messages for people on standard error. A full disk is remembered,
/// and reported when the run is over. Bytes that a terminal would act on, such as ESC in a name,
/// are shown there (lang/text/visible.h), and ASCII alone where the locale has no more; errors and
/// warnings have their colours where it has some. A pipe or a file gets the bytes.
void put_result(std::string_view text);
void put_message(std::string_view text);
/// "rob: …", one message on one line, whatever names stand in it.
void put_error(std::string_view what);
/// The same of what is no error.
void put_note(std::string_view what);

/// On a terminal: messages go on at the beginning of the line that was shown last.
void clear_message_line();

/// Whoever read the results has closed the pipe: nobody waits for the rest of the run.
bool reader_has_gone();

/// False if a result could not be written.
bool results_written();

}  // namespace rob::runtime
