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

// What "lt" or "#x20" stands for; nothing: it is no entity that needs no document type.
[[nodiscard]] std::optional<std::string> entity_text(std::string_view entity);

// Text as the content of an element or an attribute; what XML can't hold becomes U+FFFD.
[[nodiscard]] std::string xml_text(std::string_view text);

}  // namespace gaitway::behaviour
