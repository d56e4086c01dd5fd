#pragma once

#include "core/teaching/film/film_scene.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"
#include "ui/workspace/view/view.hpp"

#include <string>

/// Fields of the dialogs that export films and pictures of moments.
namespace forefront::film_fields {

inline constexpr double kFields = 72.0; ///< left edge of the fields, design pixels

/// Draws a field for a number within a range.
void number(Workspace &context, const std::string &field, double &value, double minimum, double maximum);

/// Draws a field for a whole number within a range.
template <class Whole>
void whole(Workspace &context, const std::string &field, Whole &value, double minimum, double maximum) {
    auto entered = static_cast<double>(value);
    if (ui::inputNumber(context, field, entered, 70.0F) && ui::checkWhole(context, field, entered, minimum, maximum)) {
        value = static_cast<Whole>(entered);
    }
}

/// Returns a request for the name of a new file: beside the document, named after it with `ending`, "-7.svg".
FileRequest exportRequest(const Shell &context, std::string id, std::string title, const std::string &ending);

/// Returns the part of the plane that the canvas shows clear of plates and legends.
Box2 canvasBox(const View &view);

/// Draws a row with a box for each layer, named "PREFIXlayer/WORD".
void layers(Workspace &context, const std::string &prefix, FilmLayers &layers);

} // namespace forefront::film_fields
