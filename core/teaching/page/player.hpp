#pragma once

#include <string_view>

namespace forefront {

/// The parts of the page that plays a run, as they are in player.html, player.css and player.js.
std::string_view playerBody();
std::string_view playerStyle();
std::string_view playerScript();

} // namespace forefront
