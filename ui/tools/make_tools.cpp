#include "ui/tools/pan_tool.hpp"

namespace forefront {

std::vector<std::unique_ptr<Tool>> makeTools() {
    std::vector<std::unique_ptr<Tool>> tools;
    tools.push_back(std::make_unique<PanTool>());
    return tools;
}

} // namespace forefront
