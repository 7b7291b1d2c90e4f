#pragma once

#include <string>
#include <vector>

// What the report draws of a comparison with measurements.
namespace poolhall::lab {

struct Curve {
    std::string label;
    bool is_published = false;
    bool is_points = false;  ///< not joined
    std::vector<double> x;
    std::vector<double> y;
};

struct Figure {
    std::string name;  ///< "rebound"
    std::string title;
    std::string note;
    std::string x;  ///< what the axis says
    std::string y;
    std::vector<Curve> curves;
};

}  // namespace poolhall::lab
