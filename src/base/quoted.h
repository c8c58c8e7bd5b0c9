// Text of somebody else's in messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace upbead {

constexpr std::size_t longest_quote = 60;   ///< characters (bytes) that tell a person which text is meant
constexpr std::size_t longest_path = 4096;  ///< PATH_MAX of Linux: a longer one names no file

/// The text on one line, at most `most` characters of it: of a longer one its beginning and its end with " ... "
/// between. UTF-8 is not cut within a character; control characters become blanks.
std::string excerpt(std::string_view text, std::size_t most = longest_quote);

/// The same in single quotes: 'porosity'.
std::string in_quotes(std::string_view text, std::size_t most = longest_quote);

/// A path whole, as it must be found again.
std::string quoted_path(std::string_view path);

}  // namespace upbead
