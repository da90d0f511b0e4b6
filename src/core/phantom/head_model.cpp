#include "phantom/head_model.h"

namespace gnathion {

using namespace distance;

HeadModel::HeadModel() : upper_(make_row(true)), lower_(make_row(false)) {}

}  // namespace gnathion
