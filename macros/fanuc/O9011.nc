%
O9011 (G110 CROSS POINT OF TWO LINES, AND THEIR ANGLE)
(CALL  G110 A_ H_ B_ W_)
(A  ROWS OF BUFFER A, 12.34 MEANS LINE 1 BY ROWS 1 2, LINE 2 BY 3 4   #1)
(H  PLANE  0 X-Y  1 Y-Z  2 Z-X                                 #11)
(B  ROW 1 TO 5 OF BUFFER B                                      #2)
(W  NOT 0 MEANS NO PRINT                                       #23)
(BUFFER B  X #100.., Y #115.., Z #130.., ANGLE #145..)
(THE COORDINATE ACROSS THE PLANE IS 0)
(ANGLE FROM LINE 1 TO LINE 2, -180 TO 180)
IF [#1 EQ #0] THEN #1= 12.34
IF [#2 EQ #0] THEN #2= 1
IF [#11 EQ #0] THEN #11= 0
#5= ROUND[#1*100] (THE FOUR ROWS AS ONE NUMBER)
IF [ABS[#1*100-#5] GT .01] GOTO 92
IF [#5 LT 1111] GOTO 92
IF [#5 GT 9999] GOTO 92
IF [#2 NE ROUND[#2]] GOTO 92
IF [#2 LT 1] GOTO 92
IF [#2 GT 5] GOTO 92
IF [#11 NE ROUND[#11]] GOTO 92
IF [#11 LT 0] GOTO 92
IF [#11 GT 2] GOTO 92
#8= 159+15*#11 (COLUMNS OF THE TWO AXES OF THE PLANE, BEFORE ROW 1)
#9= 174+15*#11
IF [#11 EQ 2] THEN #9= 159
#6= 1000
#7= 24
(POINTS TO #24 #25, #26 #27, #28 #29, #30 #31)
WHILE [#7 LT 31] DO1
#10= FIX[[#5+.5]/#6]
#5= #5-#10*#6
#6= #6/10
IF [#10 EQ 0] GOTO 92
IF [#[#8+#10] EQ #0] GOTO 93
IF [#[#9+#10] EQ #0] GOTO 93
#[#7]= #[#8+#10]
#[#7+1]= #[#9+#10]
#7= #7+2
END1
#12= #26-#24 (LINE 1)
#13= #27-#25
#14= #30-#28 (LINE 2)
#15= #31-#29
#16= SQRT[#12*#12+#13*#13]
#17= SQRT[#14*#14+#15*#15]
IF [#16 LT .001] GOTO 94
IF [#17 LT .001] GOTO 94
#18= #12*#15-#13*#14
IF [ABS[#18] LE #16*#17/10000] GOTO 95
#19= [[#28-#24]*#15-[#29-#25]*#14]/#18
#20= #24+#19*#12
#21= #25+#19*#13
#22= ATAN[#18]/[#12*#14+#13*#15]
IF [#22 GT 180] THEN #22= #22-360
#10= #11+1
IF [#10 EQ 3] THEN #10= 0
#24= 0
#25= 0
#26= 0
#[24+#11]= #20
#[24+#10]= #21
#[99+#2]= #24
#[114+#2]= #25
#[129+#2]= #26
#[144+#2]= #22
IF [ABS[#23] GT 0] GOTO 9
POPEN
DPRNT[+*****-----*G110*SOKUTEI*-----*****+]
DPRNT[+**********************************+]
DPRNT[+*2-LINES*CROSS*POINT*NO.#2[10]********+]
DPRNT[+**********************************+]
DPRNT[+*/CROSS*POINT*ABS.*DATA***********+]
DPRNT[+*X#24[43]*Y#25[43]*Z#26[43]*+]
DPRNT[+**********************************+]
DPRNT[+*/ANGLE*DATA**********************+]
IF [#11 EQ 1] GOTO 1
IF [#11 EQ 2] GOTO 2
DPRNT[+*X-Y*PLANE*#22[33]***************+]
GOTO 3
N1 DPRNT[+*Y-Z*PLANE*#22[33]***************+]
GOTO 3
N2 DPRNT[+*Z-X*PLANE*#22[33]***************+]
N3 DPRNT[+**********************************+]
DPRNT[+*********-----*END*-----**********+]
PCLOS
N9 M99
N92 #3000= 182 (DATA OVER)
N93 #3000= 160 (ROW EMPTY)
N94 #3000= 162 (POINTS TOO CLOSE)
N95 #3000= 163 (LINES PARALLEL)
%
