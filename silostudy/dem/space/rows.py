"""Columns of the rows of numbers that kernels read of surfaces, and the kinds in them."""

# kinds of surface, in the first column of their shapes
TURNED = 0.0
FLAT = 1.0
LEVEL = 2.0
ECCENTRIC = 3.0
# kinds of sides and ends besides free ones, 0
JOINED = 1.0  # it does not push
MEETS = 2.0  # an edge of two that meet at an angle: it pushes what is over neither
OUT_OF_REACH = 1e30  # m: component of a vector to what does not push
AXIS_X, AXIS_Y, START_R, START_Z, ALONG_R, ALONG_Z, LENGTH, START_END, END_END = range(1, 10)  # columns of a turned line
START_WAY = 10  # unit vector (r, z) into what its start meets
END_WAY = 12  # the same at its end
# columns of an eccentric cone besides those of a turned line: its start is a circle about the axis, ALONG_R and ALONG_Z are the
# whole growth of its radius and its height (m)
LEAN_X = 14  # x and y (m) of the middle of its end from that of its start
LEAN_Y = 15
# columns of a flat piece
COUNT = 1  # corners
NORMAL = 2  # unit normal
NEXT = 5  # next piece of its sheet; 0: none
FRONT = 6  # 1: its front alone pushes
FOLLOWS = 7  # 1: another piece stands for it, the first of its sheet
LAST = 22  # last piece of the group that begins with this piece, in a sheet of many; 0: none begins
BOX = 23  # least and largest x, y, z (m) of that group
# columns of a level piece
HEIGHT = 1  # m
OUTLINE = 4  # five numbers
HOLES = 9  # how many it has
# columns of both: unit vectors in the plane, each followed by its least coordinate and its length
ACROSS = 10
UPWARD = 15
# columns of any surface
RISE = 20  # speed upward (m/s)
TURN = 21  # spin about the upright axis x = y = 0 (rad/s)
BELT = 29  # velocity (three numbers, m/s) at which its face runs along it, as a belt's: it stays where it is
MORE = 32  # first column of what a flat piece says of each side, and a level piece of each hole
# columns of a side, from its first: three numbers of where it starts, then
SIDE = 3  # its kind
SIDE_WAY = 4  # unit vector into what it meets
PER_SIDE = 7  # how many they are
# columns of a hole, from its first
OPEN = 0  # 1: open
RIM = 1  # its outline, five numbers
GROWTH = 6  # speed of its half width (m/s)
FULL = 7  # half width to come (m)
PER_HOLE = 8  # how many they are
# numbers of sides of an outline; others are regular polygons, one side facing x
CIRCLE = 0.0
RECTANGLE = 4.0
