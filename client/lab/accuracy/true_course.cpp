#include "client/lab/accuracy/true_course.hpp"

#include "client/lab/ensembles/unfolding.hpp"

namespace poolhall::lab {

void TrueCourse::simulate(const Scene& scene, double sample_hz, ShotTrace& trace) {
    if (kind_ == ReferenceKind::kUnfolding) {
        unfold(scene, sample_hz, trace);
    } else {
        reference_.simulate(scene, sample_hz, trace);
    }
}

std::string_view TrueCourse::name() const {
    return kind_ == ReferenceKind::kUnfolding ? "closed form" : "event solver in 113 bits";
}

}  // namespace poolhall::lab
