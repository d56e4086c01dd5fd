#pragma once

#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"
#include "core/files/source/import_notes.hpp"

#include <string>
#include <string_view>

namespace forefront {

/// Returns the selected shapes, sources and region markers as the text of an SVG drawing, for the clipboard. Its
/// metadata holds them exactly, with their formulas and parameters, for readClipboard(); other programs see paths of
/// lines and cubics. Empty if nothing that can be copied is selected.
std::string clipboardText(const Document &document, const Selection &selection);
/// Returns the text for a whole drawing.
std::string clipboardText(const Document &drawing);

/// Reads a drawing from the text of the clipboard: an SVG drawing, a project, or lines of coordinates. Each line of
/// coordinates is a point: its first two numbers, with any separators between them. Numbers separated by tabs or
/// semicolons may have decimal commas and thousands separators. A blank line or a line of text starts a new path. A
/// path of at least four points is closed if its ends are about as close together as its nodes. Drawings of other
/// programs keep their shapes apart; `notes`, if not null, receives notes on unused content. Errors: as for the
/// readers; no-drawing.
Result<Document> readClipboard(std::string_view text, ImportNotes *notes = nullptr);

} // namespace forefront
