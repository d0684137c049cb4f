"""The sensors of a small UAV, `sensors: mems`: MEMS inertial sensors, a barometer, a pitot tube, vanes.

The values are typical of the datasheets that docs/reference/sensors.md names for each sensor. They were written from memory,
not copied from the datasheets.
"""

from __future__ import annotations

# A vane on a boom with a 12 bit encoder; 0.3 deg at 200 Hz.
_VANE = {"noise_deg_rthz": 0.03, "bias_sigma_deg": 0.3, "resolution_deg": 0.088, "low_pass_rad_s": 60.0}

MEMS: dict[str, dict[str, float]] = {
    # ICM-20689, BMI088 class; bias and scale as left by a calibration on the ground. 0.07 deg/s at 200 Hz.
    "gyro": {
        "noise_deg_s_rthz": 0.007,
        "bias_sigma_deg_s": 0.05,
        "drift_deg_s_rts": 0.001,
        "scale_error_sigma": 0.005,
        "resolution_deg_s": 0.0153,  # +-500 deg/s in 16 bits
        "low_pass_rad_s": 578.0,  # the 92 Hz filter on the chip
    },
    "accelerometer": {
        "noise_m_s2_rthz": 0.0015,  # 150 ug/rtHz
        "bias_sigma_m_s2": 0.03,  # 3 mg left by calibration
        "drift_m_s2_rts": 0.0005,
        "scale_error_sigma": 0.005,
        "resolution_m_s2": 0.0024,  # +-8 g in 16 bits
        "low_pass_rad_s": 578.0,
    },
    # Output of an attitude estimator (EKF), whose error is correlated over several seconds.
    "attitude": {"wander_deg": 0.4, "wander_time_s": 10.0, "noise_deg_rthz": 0.003},
    "heading": {"wander_deg": 0.5, "wander_time_s": 20.0, "bias_sigma_deg": 0.5, "noise_deg_rthz": 0.003},
    # MS4525DO class at 18 m/s, zeroed on the ground, with its tube; 0.3 m/s at 200 Hz.
    "airspeed": {
        "noise_m_s_rthz": 0.03,
        "bias_sigma_m_s": 0.2,
        "wander_m_s": 0.2,
        "wander_time_s": 30.0,
        "scale_error_sigma": 0.01,
        "low_pass_rad_s": 60.0,
    },
    "alpha": _VANE,
    "beta": _VANE,
    # MS5611 class: 0.15 m at 200 Hz; the wander is the effect of wind on the static pressure.
    "altitude": {
        "noise_m_rthz": 0.015,
        "wander_m": 0.3,
        "wander_time_s": 60.0,
        "resolution_m": 0.01,
        "low_pass_rad_s": 30.0,
    },
    # Output of the same estimator, from barometer and accelerometer.
    "climb_rate": {"noise_m_s_rthz": 0.005, "wander_m_s": 0.1, "wander_time_s": 5.0},
    # Satellite navigation, without corrections.
    "position": {"noise_m_rthz": 0.02, "wander_m": 1.5, "wander_time_s": 100.0, "delay_s": 0.1},
}
