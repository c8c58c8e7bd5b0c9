#include "case/cfd/flow_keys.h"

namespace upbead {

const std::vector<std::pair<std::string, FlowAxis>> flow_axis_words{{"x", FlowAxis::plus_x}, {"-x", FlowAxis::minus_x},
                                                                    {"y", FlowAxis::plus_y}, {"-y", FlowAxis::minus_y},
                                                                    {"z", FlowAxis::plus_z}, {"-z", FlowAxis::minus_z}};

const std::vector<std::pair<std::string, FlowQuantity>> flow_quantity_words{
    {"p", FlowQuantity::pressure},
    {"p_rgh", FlowQuantity::pressure_less_weight},
    {"p/rho", FlowQuantity::kinematic},
    {"p_rgh/rho", FlowQuantity::kinematic_less_weight},
    {"hydrostatic", FlowQuantity::hydrostatic}};

const std::vector<std::pair<std::string, FlowVertical>> flow_vertical_words{{"apply", FlowVertical::apply},
                                                                            {"leave_out", FlowVertical::leave_out}};

}  // namespace upbead
