# What a call changes in the control, in words.
change-radius-wear = T{ $tool } D{ $edge }, radius wear
change-radius = T{ $tool } D{ $edge }, radius
change-length-wear = T{ $tool } D{ $edge }, wear of length { $length }
change-length = T{ $tool } D{ $edge }, length { $length }
change-length-offset = T{ $tool } D{ $edge }, length { $length }, DL{ $offset }
change-radius-offset = T{ $tool } D{ $edge }, radius, DL{ $offset }
change-coarse = { $frame }, { $axis } coarse
change-fine = { $frame }, { $axis } fine
change-rotation = { $frame }, rotation about { $axis }
change-offset = { $frame }, { $axis }
change-mean = Mean value memory { $memory }
change-empirical = Empirical value { $memory }
change-register-length = Register { $register }, length
change-register-length-wear = Register { $register }, length wear
change-register-radius = Register { $register }, radius
change-register-radius-wear = Register { $register }, radius wear
change-other = { $name }
