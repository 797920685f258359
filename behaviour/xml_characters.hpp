// Which bytes XML in UTF-8 may hold, what names are made of, what entities stand for, and text made fit for
// it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace gaitway::behaviour {

// Where the first byte is that is no part of a character that XML 1.0 allows, in UTF-8; nothing: all are.
[[nodiscard]] std::optional<std::size_t> first_forbidden(std::string_view text) noexcept;

// How many bytes at the front make a name; 0: none does.
[[nodiscard]] std::size_t name_length(std::string_view text) noexcept;

// Entities become the characters that they stand for and, as XML has it in attributes, white space blanks.
// Gives the first entity that needs a document type or is none; then `text` is as it was.
[[nodiscard]] std::optional<std::string> replace_entities(std::string& text);

// Text as the content of an element or an attribute; what XML can't hold becomes U+FFFD.
[[nodiscard]] std::string xml_text(std::string_view text);

}  // namespace gaitway::behaviour
