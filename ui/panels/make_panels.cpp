#include "ui/panels/panels.hpp"

namespace forefront {

std::vector<std::unique_ptr<Panel>> makePanels() {
    std::vector<std::unique_ptr<Panel>> panels;
    panels.push_back(makeLayersPanel());
    panels.push_back(makeLogPanel());
    return panels;
}

} // namespace forefront
