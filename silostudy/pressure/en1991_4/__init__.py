"""EN 1991-4:2006, actions in silos: the design pressures, the states of equilibrium behind them, eccentric discharge.

The printed standard was not seen.  What stands here agrees in two or more public programs or was recomputed against
published numbers; what comes from one program only says so.
"""

from silostudy.pressure.en1991_4 import eccentric_rows, rows

ROWS = (*rows.ROWS, *eccentric_rows.ROWS)
