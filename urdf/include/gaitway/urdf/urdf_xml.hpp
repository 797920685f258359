// A URDF's XML, whoever wrote it.
#pragma once

#include <filesystem>
#include <string>

class TiXmlDocument;
class TiXmlElement;

namespace gaitway::urdf {

// Parses the text of `file` and returns its outermost element, <robot>, which lives as long as `document`.
// Throws input::InputError with file, line, rule and remedy for what is no well-formed XML, has a DOCTYPE, is
// nested deeper than 32 elements, or is no <robot>.
const TiXmlElement& parse_urdf_xml(const std::filesystem::path& file, const std::string& text,
                                   TiXmlDocument& document);

}  // namespace gaitway::urdf
