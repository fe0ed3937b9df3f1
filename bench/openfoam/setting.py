# SPDX-License-Identifier: MPL-2.0
"""What both codes are asked: the box, the fluid, the drive. SI."""
import dataclasses

import numpy as np


@dataclasses.dataclass
class Setting:
    pixel: float = 4e-6  # [m] voxel and cell edge
    layers: int = 4  # cells over the depth
    length: float = 800e-6  # [m] along x, the flow
    width: float = 600e-6  # [m] along y, slip sides
    density: float = 1000.0  # [kg/m^3]
    kinematic_viscosity: float = 1e-6  # [m^2/s]
    kinematic_drop: float = 0.1  # [m^2/s^2] pressure drop over density: Re about 0.1

    @property
    def depth(self) -> float:
        return self.layers * self.pixel

    def permeability(self, flow_rate: float, pore: np.ndarray) -> float:
        """k = nu (Q/A) L / (p/rho) [m^2] of the whole box, as porefines defines it."""
        ny, nx = pore.shape
        area = ny * self.pixel * self.depth
        return (self.kinematic_viscosity * flow_rate / area * nx * self.pixel / self.kinematic_drop)
