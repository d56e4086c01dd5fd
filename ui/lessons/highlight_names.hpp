#pragma once

#include <map>
#include <string>
#include <vector>

namespace forefront {

struct Shell;

/// Returns the names of widgets that lessons may outline, grouped by the prefix before their first '/'. Holds only
/// groups whose names do not depend on the run or the drawing; those of other groups are known once they are on the
/// screen.
std::map<std::string, std::vector<std::string>> highlightNames(const Shell &context);

} // namespace forefront
