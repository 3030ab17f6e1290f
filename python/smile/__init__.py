"""What robot programs written in Python use of SMILE."""
