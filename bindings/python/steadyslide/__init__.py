"""Steady sliding contact of an indenter on an elastic half-plane whose friction coefficient jumps.

    import steadyslide as ss
    p = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0")
    s = p.solve()                       # digits=50 gives mpmath numbers
    s.effective_friction, s.traction([-0.5, 0.5])

Data are exact: integers, fractions.Fraction, decimal.Decimal, strings ("0.1", "1/3"). A float stands for the decimal that
it prints; Solution.traction() says what holds for arrays of floats. Bad data raise InvalidData, a ValueError, with the
message of the command line. A solve that does not converge raises nothing: check Solution.solved and
Solution.failed_condition. Signs and units are those of the command line: the traction is <= 0, stresses are positive in
tension, z > 0 is the depth. Threads may share objects, and solve at the same time.
"""

from ._core import InvalidData, __version__
from ._problem import Problem
from ._results import (BothDirections, Contact, ContactEnd, Displacement, EstimatedError, InterfaceStress, Interval, LargestPressure, LargestStress,
                       NodalForces, Number, Picture, PossiblePoint, Proof, Residuals, Resultants, Sample, SingularPoint, Stress,
                       UnresolvedGap)
from ._solution import Solution
from ._sweep import sweep
from ._wear import WearHistory, wear

__all__ = ["BothDirections", "Contact", "ContactEnd", "Displacement", "EstimatedError", "Interval", "InvalidData",
           "InterfaceStress", "LargestPressure", "LargestStress", "NodalForces", "Number", "Picture", "PossiblePoint", "Problem", "Proof", "Residuals",
           "Resultants", "Sample", "SingularPoint", "Solution", "Stress", "UnresolvedGap", "WearHistory", "__version__", "sweep", "wear"]

InvalidData.__module__ = __name__
InvalidData.__doc__ = "Data that break a rule. The message says what is wrong, the rule, and the value."
