"""The paper's numbered equations, with the code that has each and the tests that hold it; `equations.py` checks the table."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple


class Equation(NamedTuple):
    """One numbered equation, or some that belong together.

    Attributes:
        numbers: the first and the last of them.
        says: what it says.
        code: where it is in the code; empty where it is a statement and not a part of the law.
        tests: the tests that hold it, as file::name below tests/.
    """

    numbers: tuple[int, int]
    says: str
    code: str
    tests: Sequence[str]


_DEFINITIONS, _EQUATIONS = "paper/test_definitions.py", "paper/test_equations.py"
_NOISE, _MATRIX, _LAW = (
    "paper/test_equations_30_to_38.py",
    "paper/test_input_matrix.py",
    "controllers/inversion/test_law.py",
)
_FLOWN = "benchmarks/test_section4.py::test_eq_38_flown_the_jacobian_of_a_wrong_model"
_PLANT = f"{_DEFINITIONS}::test_eq_1_7_8_the_plant_is_f_plus_b_lambda_u"
_MODEL = f"{_DEFINITIONS}::test_eq_2_4_the_design_model_is_f_m_plus_b_m_r_and_its_first_rows_are_controlled"
_ERROR = f"{_DEFINITIONS}::test_eq_9_10_11_error_of_a_plant_that_is_not_the_model"
_STEPS = f"{_EQUATIONS}::test_eq_18_19_every_step_whatever_r_does"

TABLE: tuple[Equation, ...] = (
    Equation((1, 1), "the system, healthy", "benchmarks/paper/ideal.py", [_PLANT]),
    Equation((2, 2), "its model f_m, B_m", "inversion.law.state_function", [_MODEL]),
    Equation(
        (3, 4),
        "controlled and uncontrolled rates of system and model",
        "aircraft.design_model.ROWS",
        [_MODEL],
    ),
    Equation(
        (5, 6),
        "the inversion: r for desired rates",
        "inversion.law.invert",
        [f"{_EQUATIONS}::test_eq_6_inverts_eq_5"],
    ),
    Equation(
        (7, 8),
        "the system with actuators of effectiveness Lambda, and with u = Lambda_hat^-1 r",
        "inversion.law.compensate",
        [_PLANT],
    ),
    Equation(
        (9, 11),
        "error, measured error, and both in terms of system and model",
        "inversion.law.measured_error",
        [_ERROR],
    ),
    Equation(
        (12, 12),
        "error of a perfect model",
        "",
        [f"{_EQUATIONS}::test_eq_12_error_is_b_times_lambda_over_estimate_minus_one_times_r"],
    ),
    Equation(
        (13, 13),
        "the adaptive law",
        "inversion.law.adapt",
        [f"{_EQUATIONS}::test_eq_13_one_step_is_the_papers_rate"],
    ),
    Equation(
        (14, 14),
        "the modified inverse g",
        "inversion.law.modified_inverse",
        [
            f"{_EQUATIONS}::test_eq_14_modified_inverse_is_exact",
            f"{_EQUATIONS}::test_eq_14_is_continuous_at_epsilon",
        ],
    ),
    Equation(
        (15, 16),
        "the estimation dynamics, line by line, and R, G, K",
        "",
        [f"{_DEFINITIONS}::test_eq_15_16_every_line_of_the_simplification_is_the_same"],
    ),
    Equation(
        (17, 17),
        "kappa",
        "",
        [f"{_EQUATIONS}::test_eq_17_kappa", "paper/test_erratum.py::test_eq_17_k_is_only_semidefinite"],
    ),
    Equation((18, 19), "the estimates follow the truth, each by itself", "", [_STEPS]),
    Equation(
        (20, 20),
        "case 1: nothing moves at r = 0",
        "",
        [f"{_EQUATIONS}::test_eq_20_case_1_nothing_moves_at_zero"],
    ),
    Equation(
        (21, 22),
        "case 2: a first-order lag",
        "benchmarks/paper/ideal.py",
        [f"{_EQUATIONS}::test_eq_21_22_case_2_first_order_lag"],
    ),
    Equation(
        (23, 23),
        "case 3: the same, slower",
        "",
        [
            f"{_EQUATIONS}::test_eq_23_case_3_constant_r",
            f"{_EQUATIONS}::test_eq_23_case_3_lag_slowed_by_kappa",
        ],
    ),
    Equation(
        (24, 24), "derivative of the error", "", [f"{_DEFINITIONS}::test_eq_24_derivative_of_the_error"]
    ),
    Equation(
        (25, 25),
        "error dynamics",
        "",
        [
            f"{_EQUATIONS}::test_eq_25_28_error_decays_as_the_eigenvalues_say",
            "paper/test_erratum.py::test_eq_25_first_line_has_the_estimate_and_not_its_inverse",
        ],
    ),
    Equation(
        (26, 27),
        "its characteristic equation, without B",
        "",
        [f"{_DEFINITIONS}::test_eq_26_27_the_determinant_does_not_see_b"],
    ),
    Equation(
        (28, 28),
        "its eigenvalues",
        "",
        [
            f"{_EQUATIONS}::test_eq_25_to_28_eigenvalues",
            f"{_EQUATIONS}::test_eq_28_eigenvectors_are_the_columns_of_b",
        ],
    ),
    Equation(
        (29, 29),
        "modified inversion after a failure",
        "inversion.modes.Mode",
        [
            f"{_EQUATIONS}::test_eq_29_inverts_for_every_admissible_combination",
            f"{_EQUATIONS}::test_eq_29_same_commands_as_the_papers_modified_matrix",
        ],
    ),
    Equation(
        (30, 31),
        "system and measured error with noise and disturbances",
        "",
        [f"{_NOISE}::test_eq_30_31_measured_error_contains_all_noise"],
    ),
    Equation(
        (32, 32),
        "estimation dynamics with them",
        "",
        [f"{_EQUATIONS}::test_eq_32_every_step", f"{_NOISE}::test_eq_32_one_step_on_a_measured_error"],
    ),
    Equation(
        (33, 33),
        "real error with them",
        "",
        [f"{_NOISE}::test_eq_33_real_error_lacks_the_noise_of_the_rates"],
    ),
    Equation((34, 34), "its derivative", "", [f"{_NOISE}::test_eq_34_error_dynamics_under_disturbance"]),
    Equation(
        (35, 38),
        "system, error, estimates and error dynamics with an error of the state function",
        "",
        [f"{_NOISE}::test_eq_35_36_37_38_error_of_the_state_function", f"{_FLOWN}_is_what_e_changes_by"],
    ),
    Equation(
        (39, 40),
        "system and error with an error of the input matrix",
        "",
        [f"{_MATRIX}::test_eq_39_40_error_of_the_flying_law"],
    ),
    Equation(
        (41, 41),
        "estimation dynamics with it",
        "",
        [f"{_MATRIX}::test_eq_41_rate_of_the_estimates", f"{_MATRIX}::test_eq_41_is_a_lotka_volterra_system"],
    ),
    Equation(
        (42, 42),
        "error dynamics with it",
        "",
        [
            f"{_MATRIX}::test_eq_42_rate_of_the_error",
            f"{_MATRIX}::test_eq_42_eigenvalues_are_those_of_minus_gamma_m_d",
        ],
    ),
)
