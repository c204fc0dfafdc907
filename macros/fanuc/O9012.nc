%
O9012 (G111 CROSS POINT OF THREE PLANES, ANGLE OF TWO OF THEM)
(CALL  G111 A_ H_ B_ W_)
(A  ROWS OF BUFFER A, 123.456 MEANS PLANE 1 BY ROWS 1 2 3, PLANE 2     #1)
(   BY 4 5 6, PLANE 3 BY THE THREE ROWS NOT NAMED)
(H  ANGLE OF PLANES  0 1-2  1 2-3  2 3-1                        #11)
(B  ROW 1 TO 5 OF BUFFER B                                       #2)
(W  NOT 0 MEANS NO PRINT                                        #23)
(BUFFER B  X #100.., Y #115.., Z #130.., ANGLE #145..)
(ANGLE 0 TO 180, BETWEEN THE NORMALS. A NORMAL POINTS TO WHERE ITS POINTS)
(RUN COUNTERCLOCKWISE)
IF [#2 EQ #0] THEN #2= 1
IF [#11 EQ #0] THEN #11= 0
IF [#2 NE ROUND[#2]] GOTO 92
IF [#2 LT 1] GOTO 92
IF [#2 GT 5] GOTO 92
IF [#11 NE ROUND[#11]] GOTO 92
IF [#11 LT 0] GOTO 92
IF [#11 GT 2] GOTO 92
#4= 123
#5= 456
#6= 789
IF [#1 EQ #0] GOTO 2
#10= ROUND[#1*1000]
IF [ABS[#1*1000-#10] GT .01] GOTO 92
IF [#10 LT 111111] GOTO 92
IF [#10 GT 999999] GOTO 92
#4= FIX[[#10+.5]/1000]
#5= #10-#4*1000
#6= 0 (ROWS NOT NAMED MAKE PLANE 3)
#7= 1
WHILE [#7 LE 9] DO1
#8= #10
#9= 6
WHILE [#9 GT 0] DO2
#12= FIX[[#8+.5]/10]
IF [#8-#12*10 EQ #7] GOTO 1
#8= #12
#9= #9-1
END2
#6= #6*10+#7
N1 #7= #7+1
END1
IF [#6 GT 999] GOTO 92
N2 #3= 0
WHILE [#3 LT 3] DO1
#7= FIX[[#[4+#3]+.5]/100]
#10= #[4+#3]-#7*100
#8= FIX[[#10+.5]/10]
#9= #10-#8*10
IF [#7*#8*#9 EQ 0] GOTO 92
#10= 159
WHILE [#10 LE 189] DO2
IF [#[#10+#7] EQ #0] GOTO 93
IF [#[#10+#8] EQ #0] GOTO 93
IF [#[#10+#9] EQ #0] GOTO 93
#10= #10+15
END2
IF [#3 GT 0] GOTO 3
#17= #[159+#7] (POINT OF PLANE 1, NEW ORIGIN)
#18= #[174+#7]
#19= #[189+#7]
N3 #12= #[159+#8]-#[159+#7]
#13= #[174+#8]-#[174+#7]
#14= #[189+#8]-#[189+#7]
#15= #[159+#9]-#[159+#7]
#16= #[174+#9]-#[174+#7]
#10= #[189+#9]-#[189+#7]
(LONGEST SIDE OF THE TRIANGLE, SQUARED)
#33= #12*#12+#13*#13+#14*#14
#8= #15*#15+#16*#16+#10*#10
IF [#8 GT #33] THEN #33= #8
#8= [#15-#12]*[#15-#12]+[#16-#13]*[#16-#13]+[#10-#14]*[#10-#14]
IF [#8 GT #33] THEN #33= #8
(NORMAL)
#8= #13*#10-#14*#16
#9= #14*#15-#12*#10
#10= #12*#16-#13*#15
#12= SQRT[#8*#8+#9*#9+#10*#10]
IF [#12 LE #33/10000] GOTO 94
#[24+3*#3]= #8/#12
#[25+3*#3]= #9/#12
#[26+3*#3]= #10/#12
(DISTANCE FROM THE NEW ORIGIN)
#[20+#3]= [[#[159+#7]-#17]*#8+[#[174+#7]-#18]*#9+[#[189+#7]-#19]*#10]/#12
#3= #3+1
END1
(NORMAL 1 CROSS NORMAL 2, ALL THREE TOGETHER)
#12= #25*#29-#26*#28
#13= #26*#27-#24*#29
#14= #24*#28-#25*#27
#10= #12*#30+#13*#31+#14*#32
IF [ABS[#10] LE .0001] GOTO 95
#17= #17+[#21*[#31*#26-#32*#25]+#22*#12]/#10
#18= #18+[#21*[#32*#24-#30*#26]+#22*#13]/#10
#19= #19+[#21*[#30*#25-#31*#24]+#22*#14]/#10
(ANGLE)
#5= 24+3*#11
#6= #5+3
IF [#6 GT 30] THEN #6= 24
#12= #[#5+1]*#[#6+2]-#[#5+2]*#[#6+1]
#13= #[#5+2]*#[#6]-#[#5]*#[#6+2]
#14= #[#5]*#[#6+1]-#[#5+1]*#[#6]
#15= #[#5]*#[#6]+#[#5+1]*#[#6+1]+#[#5+2]*#[#6+2]
#16= ATAN[SQRT[#12*#12+#13*#13+#14*#14]]/[#15]
#[99+#2]= #17
#[114+#2]= #18
#[129+#2]= #19
#[144+#2]= #16
IF [ABS[#23] GT 0] GOTO 9
POPEN
DPRNT[+*****-----*G111*SOKUTEI*-----*****+]
DPRNT[+**********************************+]
DPRNT[+*3-PLANE*CROSS*POINT*NO.#2[10]********+]
DPRNT[+**********************************+]
DPRNT[+*/CROSS*POINT*ABS.*DATA***********+]
DPRNT[+*X#17[43]*Y#18[43]*Z#19[43]*+]
DPRNT[+**********************************+]
DPRNT[+*/ANGLE*DATA**********************+]
IF [#11 EQ 1] GOTO 5
IF [#11 EQ 2] GOTO 6
DPRNT[+*NO.1-2*PLANE*#16[33]************+]
GOTO 7
N5 DPRNT[+*NO.2-3*PLANE*#16[33]************+]
GOTO 7
N6 DPRNT[+*NO.3-1*PLANE*#16[33]************+]
N7 DPRNT[+**********************************+]
DPRNT[+*********-----*END*-----**********+]
PCLOS
N9 M99
N92 #3000= 182 (DATA OVER)
N93 #3000= 160 (ROW EMPTY)
N94 #3000= 165 (POINTS ON ONE LINE)
N95 #3000= 164 (PLANES PARALLEL)
%
