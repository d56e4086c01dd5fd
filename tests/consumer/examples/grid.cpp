// Set the element size by values on a regular grid.
#include <forefront/forefront.hpp>

int main() {
    forefront::SizeGrid grid{.origin = {0, 0}, .pitch = {0.5, 0.5}, .columns = 9, .rows = 7, .values = {}};
    for (std::size_t row = 0; row < grid.rows; ++row) {
        for (std::size_t column = 0; column < grid.columns; ++column) {
            grid.values.push_back(0.1 + 0.05 * grid.place(column, row).x); // NaN where there is no value
        }
    }
    forefront::MeshingJob job;
    forefront::addLoop(job.domain, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
    job.spacing.background = forefront::backgroundOf(grid).value();
    return forefront::meshDomain(job) ? 0 : 1;
}
