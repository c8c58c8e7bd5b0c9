// Names in the file of a reduced model, for the writer and the reader.
#pragma once

namespace upbead::detail::model_layout {

inline const char* const kind = "upbead reduced model";
constexpr int version = 1;  ///< of this layout; raise it when a reader of the old one would misread the new one

}  // namespace upbead::detail::model_layout
