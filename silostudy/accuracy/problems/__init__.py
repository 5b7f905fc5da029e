"""One file a problem of tables/problems.csv, each with the same three names.

LADDERS: name -> settings from coarse to fine.  prepare(ladder, setting) gives a function whose CPU time is the cost and
that gives quantity -> numbers; reference() gives the same from elsewhere.  Chaotic problems take a number of members
last, in both, and give one number a member.
"""
