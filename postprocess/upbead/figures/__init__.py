"""Every figure as a function: from data to a matplotlib figure; `save(figure, path)` writes it as the scripts do."""

from ..errors import UserError

try:
    import matplotlib  # noqa: F401
except ModuleNotFoundError:
    raise UserError("figures are drawn by matplotlib, which is not installed; apt install python3-matplotlib") from None

from .amplitudes import amplitudes
from .base_pressures import base_pressures
from .calibration import calibration, calibration_spectrum
from .expected import expected
from .fit import fit
from .mesh import mesh
from .model_prototype import model_prototype, model_prototype_panel
from .reduced_model import reduced_model
from .reliability import reliability
from .response import probes, response
from .sensitivity import sensitivity
from .sliding_safety import sliding_safety
from .slip_bottom import slip_bottom
from .slip_histories import slip_histories
from .slip_safety import slip_safety
from .stability import stability
from .study import study
from .style import save
from .verification import verification
from .wave_pressure import wave_pressure

__all__ = ["amplitudes", "base_pressures", "calibration", "calibration_spectrum", "expected", "fit", "mesh", "model_prototype",
           "model_prototype_panel", "probes", "reduced_model", "reliability", "response", "save", "sensitivity", "sliding_safety", "slip_bottom", "slip_histories",
           "slip_safety", "stability", "study", "verification", "wave_pressure"]
