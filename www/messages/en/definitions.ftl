# Definition files and the program of value assignments.

definitions-intro = What this machine changes in the definition files of the measuring cycles, on newer controls in setting and machine data: array sizes and values that differ from delivery, the program that assigns the other values, and the memory they need.
definitions-channels-label = Channels that measure
definitions-read-files = Read files back
definitions-save-file = Save { $name }
definitions-array = Array
definitions-scope = Memory of
definitions-bytes = Bytes
definitions-delivered = Default
definitions-of-channel = each channel
definitions-of-control = control
