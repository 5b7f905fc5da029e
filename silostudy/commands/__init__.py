"""The sub-commands of `silostudy`, one file a group; each `add`s its parser and names the function that runs it.

Heavy imports stay inside the functions, so that a quick question gets a quick answer.
"""
